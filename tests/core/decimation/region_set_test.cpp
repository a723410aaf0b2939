// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/regions/region_set.h"

#include <gtest/gtest.h>
#include <random>
#include <set>

#include "tests/random_seed.h"

namespace proveout {
namespace {

TEST(RegionSet, IsASetOfNumbers) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    for (const std::size_t count : {1U, 63U, 64U, 65U, 128U, 1000U}) {
        RegionSet regions(count);
        std::set<std::size_t> expected;
        for (std::size_t region = 0; region < count; ++region)
            expected.insert(region);
        for (int step = 0; step < 600; ++step) {
            const std::size_t region = random() % count;
            ASSERT_EQ(regions.contains(region), expected.contains(region));
            if (random() % 3 == 0) {
                regions.insert(region);
                expected.insert(region);
            } else {
                regions.erase(region);
                expected.erase(region);
            }
            ASSERT_EQ(regions.size(), expected.size());
            ASSERT_EQ(regions.list(), std::vector<std::size_t>(expected.begin(), expected.end()));
        }
    }
}

} // namespace
} // namespace proveout
