// SPDX-License-Identifier: GPL-3.0-or-later
// Every file of tests/data/fanuc, grbl and mach: what a control does with a program, by the rule that the
// file names.
#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>

#include "tests/core/nc/case_file.h"

namespace proveout::test {

namespace {

namespace fs = std::filesystem;

class Case : public testing::TestWithParam<fs::path> {};

std::vector<fs::path> files() {
    std::vector<fs::path> paths;
    for (const char* folder : {"fanuc", "grbl", "mach"}) {
        for (const auto& entry :
             fs::directory_iterator(fs::path(PROVEOUT_SOURCE_DIR) / "tests/data" / folder)) {
            if (entry.path().extension() == ".txt")
                paths.push_back(entry.path());
        }
    }
    std::ranges::sort(paths);
    return paths;
}

std::string caseName(const testing::TestParamInfo<fs::path>& info) {
    const fs::path& path = info.param;
    const std::string folder = path.parent_path().filename().string();
    std::string name = (folder == "fanuc" ? "" : folder + "_") + path.stem().string();
    std::ranges::replace(name, '-', '_');
    return name;
}

std::string listed(const std::vector<std::string>& steps) {
    std::string text;
    for (const std::string& step : steps)
        text += "  " + step + "\n";
    return text;
}

} // namespace

TEST_P(Case, DoesWhatItsRuleSays) {
    CaseFile file = readCase(GetParam());
    // Subprograms in separate files are in the folder with the name of the case.
    file.options.subprogramFolders = {fs::path(GetParam()).replace_extension()};
    const auto program = interpret(NcText(file.program), file.options);
    const std::vector<std::string> actual = stepsOf(*program);
    const bool same = std::ranges::equal(file.steps, actual, sameStep);
    EXPECT_TRUE(same) << file.rule << "\nexpected\n" << listed(file.steps) << "actual\n" << listed(actual);
}

INSTANTIATE_TEST_SUITE_P(Dialects, Case, testing::ValuesIn(files()), caseName);

} // namespace proveout::test
