// SPDX-License-Identifier: GPL-3.0-or-later
// The table of findings, row by row.
#include "core/verification/findings/findings.h"

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace proveout {
namespace {

/// Calls `look` with each row and its table.
template<class Look>
void forEachRow(const Look& look) {
    for (const FindingTable& table : findingTables())
        for (const FindingRow* row : table.rows)
            look(table, *row);
}

TEST(Findings, HaveStableIds) {
    static const std::regex kKebab("[a-z0-9]+(-[a-z0-9]+)*");
    std::size_t rows = 0;
    forEachRow([&](const FindingTable&, const FindingRow& row) {
        ++rows;
        EXPECT_TRUE(std::regex_match(row.id, kKebab)) << row.id;
    });
    EXPECT_GT(rows, 400U) << "a rule that reads nothing would hold for ever";
}

TEST(Findings, OfOneIdHaveOneTitle) {
    std::map<std::string, std::string> titles;
    forEachRow([&](const FindingTable&, const FindingRow& row) {
        EXPECT_EQ(titles.emplace(row.id, row.title).first->second, row.title) << row.id;
    });
}

TEST(Findings, OfOneIdAreEquallySevereUnlessOneRestsOnSomethingAssumed) {
    std::map<std::string, std::vector<const FindingRow*>> rows;
    forEachRow([&](const FindingTable&, const FindingRow& row) { rows[row.id].push_back(&row); });
    for (const auto& [id, all] : rows) {
        const FindingRow& first = *all.front();
        for (const FindingRow* row : all) {
            const bool same = row->severity == first.severity && row->unverified == first.unverified;
            const bool assumed = first.severityRule == SeverityRule::warningIfAssumed &&
                                 row->severity == Severity::warning && row->unverified;
            EXPECT_TRUE(same || assumed) << id;
        }
    }
}

TEST(Findings, OfOneIdDifferInTheirSentences) {
    std::set<std::pair<std::string, std::string>> reported;
    forEachRow([&](const FindingTable&, const FindingRow& row) {
        const bool sameSentence = std::string_view(row.id) == "grid-coarse" || // two remedies
                                  std::string_view(row.id) == "code-unknown";
        EXPECT_TRUE(reported.emplace(row.id, row.text).second || sameSentence) << row.id << ": " << row.text;
    });
}

TEST(Findings, HaveShortTitles) {
    forEachRow([](const FindingTable&, const FindingRow& row) {
        const std::string_view title = row.title;
        ASSERT_FALSE(title.empty()) << row.id;
        EXPECT_LE(std::ranges::count(title, ' '), 4) << row.id << ": " << title;
        EXPECT_FALSE(title.front() >= 'a' && title.front() <= 'z') << row.id << ": " << title;
        EXPECT_NE(title.back(), '.') << row.id << ": " << title;
        EXPECT_EQ(title.find("{}"), std::string_view::npos) << row.id << ": " << title;
    });
}

/// A sentence may begin with a placeholder, a quotation or a code; its end may come from an argument.
bool isSentence(std::string_view text) {
    const bool begins = !text.empty() && (text[0] < 'a' || text[0] > 'z');
    return begins && (text.ends_with(".") || text.ends_with("?") || text.ends_with(": {}"));
}

TEST(Findings, AreSentences) {
    forEachRow([](const FindingTable&, const FindingRow& row) {
        EXPECT_TRUE(isSentence(row.text)) << row.id << ": " << row.text;
        EXPECT_TRUE(*row.hint == '\0' || isSentence(row.hint)) << row.id << ": " << row.hint;
    });
}

/// Messages that refuse input already state which values are possible, and a count of other messages has no
/// remedy of its own.
bool needsHint(const FindingTable& table, const FindingRow& row) {
    return !table.refusesInput && row.severity >= Severity::warning &&
           row.severityRule != SeverityRule::worstOmitted &&
           std::string_view(row.id) != "interpretation-stopped"; // by the user
}

TEST(Findings, AboutProgramsSayWhatToDo) {
    forEachRow([](const FindingTable& table, const FindingRow& row) {
        EXPECT_TRUE(*row.hint != '\0' || !needsHint(table, row)) << row.id;
    });
}

TEST(Findings, AreFoundByTheirIds) {
    forEachRow([](const FindingTable&, const FindingRow& row) {
        const FindingRow* found = findFinding(row.id);
        ASSERT_NE(found, nullptr) << row.id;
        EXPECT_STREQ(found->id, row.id);
        EXPECT_STREQ(findingTitle(row.id), row.title);
    });
    EXPECT_EQ(findFinding("no-such-finding"), nullptr);
    EXPECT_STREQ(findingTitle("no-such-finding"), "");
}

TEST(Findings, OfTheWindowAndOfTheCommandLineAreListed) {
    for (const auto& [id, source] : {std::pair{"export-running", FindingSource::window},
                                     std::pair{"output-overwrites", FindingSource::commandLine}}) {
        std::set<FindingSource> found;
        forEachRow([&, wanted = std::string_view(id)](const FindingTable& table, const FindingRow& row) {
            if (row.id == wanted)
                found.insert(table.noticedBy);
        });
        EXPECT_EQ(found, std::set{source}) << id;
    }
}

TEST(Findings, OfOneSourceHaveAName) {
    std::map<std::string, FindingSource> names;
    forEachRow([&](const FindingTable& table, const FindingRow&) {
        EXPECT_EQ(names.emplace(name(table.noticedBy), table.noticedBy).first->second, table.noticedBy);
    });
    EXPECT_EQ(names.count("window"), 1U);
    EXPECT_EQ(names.count("command-line"), 1U);
}

TEST(Findings, BecomeDiagnostics) {
    const FindingRow* row = findFinding("rapid-cuts");
    ASSERT_NE(row, nullptr);
    const Diagnostic diagnostic = diagnosticOf(*row, {"1.5"});
    EXPECT_EQ(diagnostic.severity, Severity::fault);
    EXPECT_FALSE(diagnostic.unverified);
    EXPECT_STREQ(diagnostic.id, "rapid-cuts");
    EXPECT_NE(message(diagnostic).find("1.5 mm"), std::string::npos);
    EXPECT_TRUE(hasIdOf(diagnostic, *row));
    EXPECT_FALSE(hasIdOf(diagnostic, *findFinding("export-running")));
    const Diagnostics refused = failure(*row, {"2"}, "a.nc").value();
    ASSERT_EQ(refused.size(), 1U);
    EXPECT_EQ(refused.front().file, "a.nc");
}

} // namespace
} // namespace proveout
