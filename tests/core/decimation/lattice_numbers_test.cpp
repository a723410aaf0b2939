// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/lattice/lattice_numbers.h"

#include <gtest/gtest.h>
#include <map>
#include <random>

#include "core/base/memory.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

TEST(LatticeNumbers, countInTheOrderOfTheFirstUse) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    for (const std::uint32_t points : {1U, 63U, 64U, 65U, 5000U}) {
        LatticeNumbers numbers(points);
        std::map<std::uint32_t, std::uint32_t> expected;
        for (std::uint32_t k = 0; k < 2000; ++k) {
            const auto lattice = static_cast<std::uint32_t>(random() % points);
            const auto next = static_cast<std::uint32_t>(expected.size());
            EXPECT_EQ(numbers.number(lattice), expected.try_emplace(lattice, next).first->second);
        }
        for (std::uint32_t lattice = 0; lattice < points; ++lattice)
            EXPECT_EQ(numbers.find(lattice),
                      expected.contains(lattice) ? expected.at(lattice) : LatticeNumbers::kUnused);
        for (std::uint32_t number = 0; number < numbers.used().size(); ++number)
            EXPECT_EQ(expected.at(numbers.used()[number]), number);
        EXPECT_EQ(std::move(numbers).releaseUsed().size(), expected.size());
    }
}

/// The map of a panel of 2 m² at 0.1 mm, of which a decimated mesh uses one point of two thousand.
TEST(LatticeNumbers, ofFewPointsNeedLittleMemory) {
#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "sanitizers take memory of their own";
#endif
    constexpr std::uint32_t kPoints = 200'000'000;
    constexpr std::uint32_t kUsed = 100'000;
    const std::uint64_t before = residentMemoryBytes();
    LatticeNumbers numbers(kPoints);
    for (std::uint32_t k = 0; k < kUsed; ++k)
        EXPECT_EQ(numbers.number(k * (kPoints / kUsed)), k);
    EXPECT_LT(residentMemoryBytes() - before, 80'000'000U);
}

} // namespace
} // namespace proveout
