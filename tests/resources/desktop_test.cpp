// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <iterator>
#include <regex>
#include <set>
#include <string>

#include "core/formats/formats.h"
#include "tests/core/temporary_folder.h"

namespace proveout {
namespace {

namespace fs = std::filesystem;

const fs::path kDesktop = fs::path(PROVEOUT_SOURCE_DIR) / "resources/desktop";

std::string textOf(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::set<std::string> matches(const std::string& text, const std::string& pattern) {
    const std::regex expression(pattern);
    std::set<std::string> found;
    for (std::sregex_iterator match(text.begin(), text.end(), expression), end; match != end; ++match)
        found.insert((*match)[1]);
    return found;
}

bool has(const std::string& program) {
    return std::system(("command -v " + program + " >/dev/null").c_str()) == 0;
}

TEST(Desktop, TypesOfTheEntryAreDefined) {
    const std::string entry = textOf(kDesktop / "proveout.desktop");
    const std::string list = *matches(entry, "\nMimeType=([^\n]*)").begin();
    std::set<std::string> defined =
        matches(textOf(kDesktop / "proveout.xml"), "<mime-type type=\"([^\"]*)\"");
    EXPECT_EQ(defined.erase("application/x-netcdf"), 1U) << "which is only told apart";
    EXPECT_THAT(defined, testing::SizeIs(2));
    // Defined by shared-mime-info and by LinuxCNC.
    defined.insert({"text/x.gcode", "text/ngc"});
    EXPECT_EQ(matches(list, "([^;]+);"), defined);
}

TEST(Desktop, EndingsAreThoseThatTheWindowOpens) {
    std::set<std::string> endings =
        matches(textOf(fs::path(PROVEOUT_SOURCE_DIR) / "ui/files/file_flow.cpp"), "(\\*\\.[a-z]+)(?=[ \"])");
    // Disk images and plain texts.
    for (const char* other : {"*.iso", "*.txt"})
        EXPECT_EQ(endings.erase(other), 1U) << other;
    for (const char* extension : findFormat("job")->extensions)
        endings.insert(std::string("*") + extension);
    EXPECT_EQ(matches(textOf(kDesktop / "proveout.xml"), "<glob pattern=\"([^\"]*)\""), endings);
}

TEST(Desktop, TheDatabaseOfTypesTakesThem) {
    if (!has("update-mime-database"))
        GTEST_SKIP() << "update-mime-database is not installed";
    const TemporaryFolder folder;
    fs::create_directories(folder / "mime/packages");
    fs::copy_file(kDesktop / "proveout.xml", folder / "mime/packages/proveout.xml");
    const std::string command = "XDG_DATA_HOME='" + folder.path().string() + "' update-mime-database '" +
                                (folder / "mime").string() + "' >'" + (folder / "printed").string() +
                                "' 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0);
    EXPECT_EQ(textOf(folder / "printed"), "") << "warnings";
    const std::string globs = textOf(folder / "mime/globs2");
    EXPECT_THAT(globs, testing::HasSubstr("50:application/x-proveout-job:*.proveout\n"));
    EXPECT_THAT(globs, testing::HasSubstr("50:text/x-nc-program:*.nc\n"));
    EXPECT_THAT(textOf(folder / "mime/subclasses"), testing::HasSubstr("text/x-nc-program text/plain\n"));
    EXPECT_THAT(textOf(folder / "mime/icons"), testing::HasSubstr("application/x-proveout-job:proveout\n"));
}

TEST(Desktop, TheXmlIsWellFormed) {
    if (!has("xmllint"))
        GTEST_SKIP() << "xmllint is not installed";
    EXPECT_EQ(std::system(("xmllint --noout '" + (kDesktop / "proveout.xml").string() + "'").c_str()), 0);
}

TEST(Desktop, TheEntryIsValid) {
    if (!has("desktop-file-validate"))
        GTEST_SKIP() << "desktop-file-validate is not installed";
    EXPECT_EQ(
        std::system(("desktop-file-validate '" + (kDesktop / "proveout.desktop").string() + "'").c_str()), 0);
}

} // namespace
} // namespace proveout
