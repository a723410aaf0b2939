// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/line_diff.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <random>
#include <string_view>
#include <vector>

#include "tests/random_seed.h"

namespace proveout {
namespace {

using Lines = std::vector<std::string_view>;

/// Applies the changes to `before`, taking only inserted lines from `after`.
Lines applied(const Lines& before, const Lines& after, const std::vector<LineChange>& changes) {
    Lines result;
    std::size_t at = 0;
    for (const LineChange& change : changes) {
        result.insert(result.end(), before.begin() + static_cast<std::ptrdiff_t>(at),
                      before.begin() + static_cast<std::ptrdiff_t>(change.beforeFirst));
        result.insert(result.end(), after.begin() + static_cast<std::ptrdiff_t>(change.afterFirst),
                      after.begin() + static_cast<std::ptrdiff_t>(change.afterLast));
        at = change.beforeLast;
    }
    result.insert(result.end(), before.begin() + static_cast<std::ptrdiff_t>(at), before.end());
    return result;
}

std::size_t edits(const std::vector<LineChange>& changes) {
    std::size_t count = 0;
    for (const LineChange& change : changes)
        count += change.beforeLast - change.beforeFirst + change.afterLast - change.afterFirst;
    return count;
}

/// The minimum number of edits, from the table of longest common subsequences.
std::size_t fewestEdits(const Lines& before, const Lines& after) {
    std::vector<std::vector<std::size_t>> common(before.size() + 1,
                                                 std::vector<std::size_t>(after.size() + 1, 0));
    for (std::size_t i = 1; i <= before.size(); ++i)
        for (std::size_t j = 1; j <= after.size(); ++j)
            common[i][j] = before[i - 1] == after[j - 1] ? common[i - 1][j - 1] + 1
                                                         : std::max(common[i - 1][j], common[i][j - 1]);
    return before.size() + after.size() - 2 * common[before.size()][after.size()];
}

TEST(LineDiff, EqualTextsHaveNoChange) {
    EXPECT_TRUE(compareLines({}, {}).empty());
    EXPECT_TRUE(compareLines({"G0 X1", "G1 Z-1"}, {"G0 X1", "G1 Z-1"}).empty());
}

TEST(LineDiff, NamesTheLinesThatDiffer) {
    const Lines before{"G21", "G0 X1", "G1 Z-1", "M2"};
    const Lines after{"G21", "G0 X2", "G1 Z-1", "G0 Z5", "M2"};
    const std::vector<LineChange> expected{{1, 2, 1, 2}, {3, 3, 3, 4}};
    EXPECT_EQ(compareLines(before, after), expected);
    EXPECT_EQ(compareLines({}, {"M2"}), (std::vector<LineChange>{{0, 0, 0, 1}}));
    EXPECT_EQ(compareLines({"M2"}, {}), (std::vector<LineChange>{{0, 1, 0, 0}}));
}

TEST(LineDiff, IsRightAndShortestForRandomTexts) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    constexpr std::array<std::string_view, 4> kWords{"G0", "G1", "X1", "M2"};
    for (int round = 0; round < roundsOf(3000); ++round) {
        const auto text = [&] {
            Lines lines(random() % 13);
            std::generate(lines.begin(), lines.end(), [&] { return kWords[random() % kWords.size()]; });
            return lines;
        };
        const Lines before = text();
        const Lines after = text();
        const auto changes = compareLines(before, after);
        ASSERT_EQ(applied(before, after, changes), after);
        ASSERT_EQ(edits(changes), fewestEdits(before, after));
        const auto bounded = compareLines(before, after, 2);
        ASSERT_EQ(applied(before, after, bounded), after);
    }
}

TEST(LineDiff, GivesUpWhereTextsHaveLittleInCommon) {
    Lines before(100'000, "G1 X1");
    Lines after(100'000, "G1 X2");
    before.front() = after.front() = "G21";
    before.back() = after.back() = "M2";
    EXPECT_EQ(compareLines(before, after), (std::vector<LineChange>{{1, 99'999, 1, 99'999}}));
}

} // namespace
} // namespace proveout
