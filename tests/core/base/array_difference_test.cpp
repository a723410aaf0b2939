// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/array_difference.h"

#include <functional>
#include <gtest/gtest.h>
#include <random>

#include "tests/random_seed.h"

namespace proveout {
namespace {

/// Element by element, from both ends.
ArrayStretch expected(const PersistentArray<int>& a, const PersistentArray<int>& b) {
    const std::size_t most = std::max(a.size(), b.size());
    const auto isSame = [&](std::size_t i) { return i < a.size() && i < b.size() && a[i] == b[i]; };
    ArrayStretch stretch{0, most};
    while (stretch.first < most && isSame(stretch.first))
        ++stretch.first;
    while (stretch.end > stretch.first && isSame(stretch.end - 1))
        --stretch.end;
    return stretch;
}

TEST(ArrayDifference, IsTheShortestStretchAfterAnyChanges) {
    const unsigned seed = randomSeed();
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto below = [&random](std::size_t n) { return static_cast<std::size_t>(random()) % n; };
    for (int round = 0; round < 2000; ++round) {
        const PersistentArray<int> before(below(1200), 0);
        PersistentArray<int> after = before;
        for (std::size_t change = below(5); change > 0 && !after.empty(); --change)
            after.edit(below(after.size())) = static_cast<int>(below(3)); // also to the value that it has
        if (below(4) == 0)
            after.truncate(below(after.size() + 1));
        for (std::size_t added = below(4) == 0 ? below(300) : 0; added > 0; --added)
            after.push_back(static_cast<int>(below(2)));
        const ArrayStretch found = difference(after, before, std::equal_to<>());
        const ArrayStretch wanted = expected(after, before);
        ASSERT_EQ(found.first, wanted.first) << round;
        ASSERT_EQ(found.end, wanted.end) << round;
    }
}

TEST(ArrayDifference, ReadsOnlyTheChunksThatAreNotShared) {
    PersistentArray<int> array(1'000'000, 7);
    const PersistentArray<int> copy = array;
    array.edit(500'000) = 8;
    std::size_t compared = 0;
    const ArrayStretch found = difference(array, copy, [&](int a, int b) {
        ++compared;
        return a == b;
    });
    EXPECT_EQ(found.first, 500'000U);
    EXPECT_EQ(found.end, 500'001U);
    EXPECT_LE(compared, PersistentArray<int>::kChunkSize + 2);
}

} // namespace
} // namespace proveout
