// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing is told outside of the table: read from the sources of the core themselves.
#include <cstddef>
#include <regex>
#include <string>

#include <gtest/gtest.h>

#include "core/verification/findings/findings.h"
#include "tests/architecture/source_tree.h"

namespace proveout {
namespace {

std::size_t rowsInTables() {
    std::size_t rows = 0;
    for (const FindingTable& table : findingTables())
        rows += table.rows.size();
    return rows;
}

TEST(FindingSources, EveryRowIsCollected) {
    static const std::regex kRow(R"re(constexpr FindingRow k\w+\{[^"]*?"([a-z0-9-]+)")re");
    static const std::regex kConstant(R"(constexpr FindingRow k\w+\{)");
    std::size_t constants = 0;
    for (const SourceFile& file : sourceTree()) {
        if (!file.in("core") || !file.isCpp())
            continue;
        for (std::sregex_iterator each(file.text.begin(), file.text.end(), kRow), end; each != end; ++each)
            EXPECT_NE(findFinding((*each)[1].str()), nullptr) << file.path << ": " << (*each)[1];
        for (std::sregex_iterator each(file.text.begin(), file.text.end(), kConstant), end; each != end;
             ++each)
            ++constants;
    }
    EXPECT_EQ(constants, rowsInTables()) << "a row is in no table, or in two";
}

TEST(FindingSources, NothingIsToldWithoutARow) {
    static const std::regex kTold(
        R"re((failure|Diagnostic)\s*[({]\s*"|\b(warning|diagnostic|error|finding|note|more)\.id = "|\bDiagnostic \w+;)re");
    for (const SourceFile& file : sourceTree()) {
        const bool isTheType = file.path.starts_with("core/base/diagnostic.");
        std::smatch told;
        if (file.in("core") && file.isCpp() && !isTheType) {
            EXPECT_FALSE(std::regex_search(file.text, told, kTold)) << file.path << ": " << told.str();
        }
    }
}

} // namespace
} // namespace proveout
