// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace proveout {
namespace {

const std::filesystem::path kIcons = std::filesystem::path(PROVEOUT_SOURCE_DIR) / "resources/icons";

std::string textOf(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::set<std::string> matches(const std::string& text, const std::regex& pattern) {
    std::set<std::string> found;
    for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match)
        found.insert((*match)[1]);
    return found;
}

std::set<std::string> iconFiles() {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(kIcons))
        if (entry.path().extension() == ".svg")
            names.insert(entry.path().stem().string());
    return names;
}

TEST(Icons, AreTheFilesOfTheResourceList) {
    EXPECT_EQ(matches(textOf(kIcons / "icons.qrc"), std::regex("<file>(.*)\\.svg</file>")), iconFiles());
}

TEST(Icons, HaveOneColourThatTheWindowCanReplace) {
    for (const std::string& name : iconFiles()) {
        const std::string svg = textOf(kIcons / (name + ".svg"));
        const std::set<std::string> colours =
            matches(svg, std::regex("(?:stroke|fill)=\"(currentColor|#[0-9a-fA-F]+|[a-z]+)\""));
        if (name != "proveout") {
            for (const std::string& colour : colours)
                EXPECT_TRUE(colour == "currentColor" || colour == "none") << name << ": " << colour;
            EXPECT_EQ(colours.count("currentColor"), 1U) << name;
            EXPECT_NE(svg.find("viewBox=\"0 0 24 24\""), std::string::npos) << name;
        }
    }
}

} // namespace
} // namespace proveout
