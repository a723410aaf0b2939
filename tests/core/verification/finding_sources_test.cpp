// SPDX-License-Identifier: GPL-3.0-or-later
// Every finding must come from the table; checked in the sources of the program.
#include <cstddef>
#include <regex>
#include <set>
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

bool isOfTheProgram(const SourceFile& file) {
    return (file.in("core") || file.in("ui") || file.in("app")) && file.isCpp();
}

TEST(FindingSources, EveryRowIsCollected) {
    static const std::regex kRow(R"re(constexpr FindingRow k\w+\{[^"]*?"([a-z0-9-]+)")re");
    static const std::regex kConstant(R"(constexpr FindingRow k\w+\{)");
    std::size_t constants = 0;
    for (const SourceFile& file : sourceTree()) {
        if (!isOfTheProgram(file))
            continue;
        for (std::sregex_iterator each(file.text.begin(), file.text.end(), kRow), end; each != end; ++each)
            EXPECT_NE(findFinding((*each)[1].str()), nullptr) << file.path << ": " << (*each)[1];
        for (std::sregex_iterator each(file.text.begin(), file.text.end(), kConstant), end; each != end;
             ++each)
            ++constants;
    }
    EXPECT_EQ(constants, rowsInTables()) << "a row is in no table, or in two";
}

bool holdsRows(const SourceFile& file) {
    return file.path.ends_with("_findings.h") || file.path.ends_with("messages.h");
}

TEST(FindingSources, NothingIsReportedWithoutARow) {
    static const std::regex kReported(
        R"re((failure|Diagnostic)\s*[({]\s*"|\b(warning|diagnostic|error|finding|note|more)\.id = "|\bDiagnostic \w+;|\[[a-z-]+\]\\n")re");
    std::set<std::string> tops;
    for (const SourceFile& file : sourceTree()) {
        const bool isTheType = file.path.starts_with("core/base/diagnostic.");
        std::smatch reported;
        if (isOfTheProgram(file) && !isTheType) {
            tops.insert(file.path.substr(0, file.path.find('/')));
            EXPECT_FALSE(std::regex_search(file.text, reported, kReported))
                << file.path << ": " << reported.str();
        }
    }
    EXPECT_EQ(tops, (std::set<std::string>{"app", "core", "ui"}));
}

/// A finding must be recognised by its row (hasIdOf()): a copy of its id would survive its removal.
TEST(FindingSources, NoIdIsWrittenOutsideOfTheRows) {
    static const std::regex kQuoted(R"re("([a-z0-9]+(-[a-z0-9]+)+)"|\bid\b[^;\n]*(with\(|==) ?"[a-z-]+")re");
    static const std::regex kComment(R"(//[^\n]*)");
    for (const SourceFile& file : sourceTree()) {
        if (!isOfTheProgram(file) || holdsRows(file))
            continue;
        const std::string code = std::regex_replace(file.text, kComment, "");
        for (std::sregex_iterator each(code.begin(), code.end(), kQuoted), end; each != end; ++each) {
            const bool isKey = (*each)[1].matched && findFinding((*each)[1].str()) == nullptr;
            EXPECT_TRUE(isKey) << file.path << ": " << each->str();
        }
    }
}

} // namespace
} // namespace proveout
