// SPDX-License-Identifier: GPL-3.0-or-later
// The pages of the house: what they link to is there, and the front page is one that is read.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/architecture/source_tree.h"

namespace proveout {
namespace {

constexpr std::size_t kLongestFrontPage = 4500; // bytes

const std::filesystem::path kRoot(PROVEOUT_SOURCE_DIR);

SourceFile frontPage() {
    std::ifstream stream(kRoot / "README.md", std::ios::binary);
    return {"README.md", {std::istreambuf_iterator<char>(stream), {}}, {}};
}

std::vector<SourceFile> pages() {
    std::vector<SourceFile> found{frontPage()};
    for (const SourceFile& file : sourceTree())
        if (file.path.ends_with(".md"))
            found.push_back(file);
    return found;
}

/// The files of the house that a page links to, from its folder.
std::vector<std::string> linksOf(const std::string& text) {
    static const std::regex kLink(R"(\]\(([^)#\s]+)(#[^)]*)?\))");
    std::vector<std::string> links;
    for (std::sregex_iterator at(text.begin(), text.end(), kLink), end; at != end; ++at)
        if ((*at)[1].str().find("://") == std::string::npos)
            links.push_back((*at)[1]);
    return links;
}

TEST(Pages, LinkToFilesThatAreThere) {
    EXPECT_EQ(linksOf("[a](b/c.md#d) ![p](e.png) [f](https://g)"),
              (std::vector<std::string>{"b/c.md", "e.png"}));
    std::size_t links = 0;
    for (const SourceFile& page : pages())
        for (const std::string& link : linksOf(page.text)) {
            ++links;
            const auto file = kRoot / std::filesystem::path(page.path).parent_path() / link;
            EXPECT_TRUE(std::filesystem::exists(file)) << page.path << " links to " << link;
        }
    EXPECT_GT(links, 10U);
}

TEST(Pages, TheFrontPageIsShort) {
    EXPECT_LT(frontPage().text.size(), kLongestFrontPage);
}

} // namespace
} // namespace proveout
