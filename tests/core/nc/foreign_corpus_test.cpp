// SPDX-License-Identifier: GPL-3.0-or-later
// The programs of the corpus: those for unsupported controls are identified, and supported ones are not
// mistaken for them.
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "core/nc/run/foreign_text.h"

namespace proveout::test {

namespace {

namespace fs = std::filesystem;

const fs::path kForeignCorpus = fs::path(PROVEOUT_SHARED_DIR) / "corpus";

/// Files that are programs in the corpus's list, but for a control (or other software) that we do not
/// support.
const std::map<std::string, std::string> kForeign{
    {"gcodeworkshop/examples/SINUMERIK840D.nc", "a Siemens Sinumerik program"},
    {"gcodeworkshop/examples/SINUMERIK850.nc", "a Siemens Sinumerik program"},
    {"gcodeworkshop/examples/FLANGE.nc", "an Okuma OSP program"},
    {"gcodeworkshop/examples/TOKARKA.NC", "a lathe program"},
    {"gpr/gcode_samples/camaster_sample.tap", "a WinCNC program"},
    {"cncjs/examples/gcode/sample.gcode", "a 3D printer program"},
};

/// Path and kind of every file in the list.
std::vector<std::pair<std::string, std::string>> listed() {
    std::vector<std::pair<std::string, std::string>> files;
    std::ifstream in(kForeignCorpus / "MANIFEST.csv");
    std::string line;
    std::getline(in, line);
    while (std::getline(in, line)) {
        std::istringstream fields(line);
        std::string path;
        std::string set;
        std::string kind;
        if (std::getline(fields, path, ',') && std::getline(fields, set, ',') &&
            std::getline(fields, kind, ','))
            files.emplace_back(path, kind);
    }
    return files;
}

std::string kindOf(const fs::path& file) {
    const auto text = NcText::load(file);
    if (!text)
        return text.error().front().id;
    const auto found = findForeignText(*text);
    return found ? found->kind : "";
}

} // namespace

TEST(ForeignCorpus, NamesProgramsOfOthersAndNoneOfOurs) {
    if (!fs::exists(kForeignCorpus / "MANIFEST.csv"))
        GTEST_SKIP() << "the corpus is not here";
    int ours = 0;
    int heidenhain = 0;
    for (const auto& [path, kind] : listed()) {
        if (kind == "nc") {
            const auto foreign = kForeign.find(path);
            EXPECT_EQ(kindOf(kForeignCorpus / path), foreign == kForeign.end() ? "" : foreign->second)
                << path;
            ours += foreign == kForeign.end() ? 1 : 0;
        } else if (kind == "nc-heidenhain") {
            EXPECT_EQ(kindOf(kForeignCorpus / path), "a Heidenhain conversational program") << path;
            ++heidenhain;
        } else if (path.ends_with(".camotics")) {
            EXPECT_EQ(kindOf(kForeignCorpus / path), "a CAMotics project") << path;
        } else if (kind == "nc-fault" && fs::exists(kForeignCorpus / path)) {
            const std::string found = kindOf(kForeignCorpus / path);
            EXPECT_TRUE(found.empty() || found.starts_with("nc-")) << path << ": " << found;
        }
    }
    EXPECT_GT(ours, 350);
    EXPECT_GT(heidenhain, 15);
}

TEST(ForeignCorpus, NamesMeshes) {
    if (!fs::exists(kForeignCorpus))
        GTEST_SKIP() << "the corpus is not here";
    int meshes = 0;
    for (const auto& [path, kind] : listed()) {
        if (kind != "stl" || !fs::exists(kForeignCorpus / path))
            continue;
        ++meshes;
        const std::string found = kindOf(kForeignCorpus / path);
        EXPECT_TRUE(found == "an STL mesh" || found == "nc-binary") << path << ": " << found;
    }
    EXPECT_GT(meshes, 20);
}

} // namespace proveout::test
