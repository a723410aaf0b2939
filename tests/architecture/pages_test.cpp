// SPDX-License-Identifier: GPL-3.0-or-later
// The pages of the repository: their links must exist, the pictures of the guide must be small and in use,
// and each page must be short enough to read.
#include <algorithm>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/architecture/source_tree.h"

namespace proveout {
namespace {

constexpr std::size_t kLongestFrontPage = 4500; // bytes
// Two screens, with short or with long lines.
constexpr std::ptrdiff_t kMostLines = 90;
constexpr std::size_t kLongestPage = 9000;      // bytes
constexpr std::size_t kLargestPicture = 60'000; // bytes; resources/help/make_pictures.sh has the same limit
const std::string kGuide = "resources/help/guide";
const std::string kContributing = "tests/README.md";

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

/// The first capture group of each match.
std::vector<std::string> matchesOf(const std::string& text, const std::regex& pattern) {
    std::vector<std::string> matches;
    for (std::sregex_iterator at(text.begin(), text.end(), pattern), end; at != end; ++at)
        matches.push_back((*at)[1]);
    return matches;
}

/// The files of the repository that a page links to or shows, relative to its folder.
std::vector<std::string> linksOf(const std::string& text) {
    static const std::regex kLink(R"(\]\(([^)#\s]+)(#[^)]*)?\))");
    std::vector<std::string> links = matchesOf(text, kLink);
    std::erase_if(links, [](const std::string& link) { return link.find("://") != std::string::npos; });
    return links;
}

std::filesystem::path fileOf(const SourceFile& page, const std::string& link) {
    return (std::filesystem::path(page.path).parent_path() / link).lexically_normal();
}

/// The anchors of a page's headings, as GitHub generates them for ASCII.
std::set<std::string> anchorsOf(const std::string& text) {
    static const std::regex kHeading(R"((?:^|\n)#+ ([^\n]+))");
    std::set<std::string> anchors;
    for (const std::string& heading : matchesOf(text, kHeading)) {
        std::string anchor;
        for (const char character : heading)
            if (character == ' ' || character == '-')
                anchor += '-';
            else if (std::isalnum(static_cast<unsigned char>(character)) != 0)
                anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(character)));
        anchors.insert(anchor);
    }
    return anchors;
}

/// The names of files and folders in backticks in the rows of a table, from the root: a name without a folder
/// is in the folder of the one before it. Names with a placeholder are skipped.
std::vector<std::string> pathsOfRow(const std::string& row) {
    static const std::regex kName("`([^`]+)`");
    static const std::set<std::string> kTops{"app", "core", "resources", "tests", "translations", "ui"};
    std::vector<std::string> paths;
    std::string folder;
    for (const std::string& name : matchesOf(row, kName)) {
        const std::size_t slash = name.rfind('/');
        if (kTops.contains(name.substr(0, name.find('/'))) && slash != std::string::npos)
            folder = name.substr(0, slash + 1);
        else if (slash != std::string::npos || folder.empty())
            continue;
        if (name.find_first_of("<*…") == std::string::npos && name.find('.') != std::string::npos &&
            !name.starts_with('.'))
            paths.push_back(slash == std::string::npos ? folder + name : name);
    }
    return paths;
}

TEST(Pages, LinkToFilesThatAreThere) {
    EXPECT_EQ(linksOf("[a](b/c.md#d) ![p](e.png) [f](https://g)"),
              (std::vector<std::string>{"b/c.md", "e.png"}));
    std::size_t links = 0;
    for (const SourceFile& page : pages())
        for (const std::string& link : linksOf(page.text)) {
            ++links;
            EXPECT_TRUE(std::filesystem::exists(kRoot / fileOf(page, link)))
                << page.path << " links to " << link;
        }
    EXPECT_GT(links, 40U);
}

TEST(Pages, LinkToHeadingsThatAreThere) {
    EXPECT_EQ(anchorsOf("# A b\n\n## It's: c"), (std::set<std::string>{"a-b", "its-c"}));
    static const std::regex kAnchored(R"(\]\(([^)\s:]+\.md#[^)]+)\))");
    std::size_t links = 0;
    const std::vector<SourceFile> all = pages();
    for (const SourceFile& page : all)
        for (const std::string& link : matchesOf(page.text, kAnchored)) {
            ++links;
            const std::size_t hash = link.find('#');
            const std::string path = fileOf(page, link.substr(0, hash)).generic_string();
            const auto target = std::ranges::find(all, path, &SourceFile::path);
            ASSERT_NE(target, all.end()) << page.path << " links to " << link;
            EXPECT_TRUE(anchorsOf(target->text).contains(link.substr(hash + 1)))
                << page.path << " links to " << link;
        }
    EXPECT_GT(links, 2U);
}

TEST(Pages, AreTwoScreensLong) {
    EXPECT_LT(frontPage().text.size(), kLongestFrontPage);
    for (const SourceFile& page : pages()) {
        if (page.in("resources/help") || page.path == "translations/GLOSSARY.md") // a reference list of words
            continue;
        EXPECT_LE(std::ranges::count(page.text, '\n'), kMostLines) << page.path;
        EXPECT_LE(page.text.size(), kLongestPage) << page.path;
    }
}

TEST(Pages, ShowPicturesThatAreThereAndSmall) {
    static const std::regex kPicture(R"(!\[[^\]]*\]\(([^)\s]+)\))");
    std::set<std::string> shown;
    for (const SourceFile& page : pages())
        for (const std::string& picture : matchesOf(page.text, kPicture))
            shown.insert(fileOf(page, picture).generic_string());
    std::ifstream rows(kRoot / "resources/help/pictures.txt");
    std::set<std::string> made;
    for (std::string line; std::getline(rows, line);)
        if (!line.empty() && line.front() != '#')
            made.insert(kGuide + "/pictures/" + line.substr(0, line.find(' ')) + ".png");
    EXPECT_EQ(shown, made) << "each picture is a row of pictures.txt, and each row is shown";
    std::set<std::string> there;
    for (const SourceFile& file : sourceTree())
        if (file.path.ends_with(".png")) {
            there.insert(file.path);
            EXPECT_LE(file.text.size(), kLargestPicture) << file.path;
        }
    EXPECT_EQ(there, made);
    EXPECT_GE(there.size(), 5U);
}

TEST(Pages, NameFilesForANewDeveloperThatAreThere) {
    EXPECT_EQ(pathsOfRow("| x | `core/a/b.h`, `.cpp`, `c.h` | `d/e.h`; `f_`, `ui/<p>/` | `tests/g.cpp` |"),
              (std::vector<std::string>{"core/a/b.h", "core/a/c.h", "tests/g.cpp"}));
    const std::vector<SourceFile> all = pages();
    const auto page = std::ranges::find(all, kContributing, &SourceFile::path);
    ASSERT_NE(page, all.end());
    std::istringstream lines(page->text.substr(page->text.find("## Contributing")));
    std::size_t rows = 0;
    for (std::string line; std::getline(lines, line);) {
        const std::vector<std::string> paths =
            line.starts_with("| ") ? pathsOfRow(line) : std::vector<std::string>();
        rows += paths.empty() ? 0 : 1;
        for (const std::string& path : paths)
            EXPECT_TRUE(std::filesystem::exists(kRoot / path)) << path << " in: " << line;
    }
    EXPECT_EQ(rows, 9U);
}

} // namespace
} // namespace proveout
