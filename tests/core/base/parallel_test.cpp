// SPDX-License-Identifier: GPL-3.0-or-later
// Under ThreadSanitizer it is also checked that the loops order what is written before, in and after them.
#include "core/base/parallel.h"

#include <gtest/gtest.h>
#include <numeric>
#include <random>
#include <stdexcept>
#include <thread>
#include <vector>

#include "tests/random_seed.h"

namespace proveout {
namespace {

TEST(Parallel, CallsEachNumberOnceWhateverTheGrain) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    for (int round = 0; round < roundsOf(200); ++round) {
        const std::size_t count = random() % 3000;
        const std::size_t grain = 1 + random() % 50;
        std::vector<int> given(count);
        std::iota(given.begin(), given.end(), 1);
        std::vector<int> calls(count);
        inParallelRanges(count, grain, [&](std::size_t first, std::size_t last) {
            EXPECT_LT(first, last);
            for (std::size_t k = first; k < last; ++k)
                calls[k] += given[k];
        });
        ASSERT_EQ(calls, given);
        inParallel(count, [&](std::size_t k) { calls[k] -= given[k] - 1; });
        ASSERT_EQ(calls, std::vector<int>(count, 1));
    }
}

TEST(Parallel, FindsTheLargest) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    EXPECT_EQ(largestInParallel(0, 7, [](std::size_t) { return 1.0; }), 0);
    for (int round = 0; round < roundsOf(100); ++round) {
        std::vector<double> values(1 + random() % 2000);
        for (double& value : values)
            value = std::uniform_real_distribution<double>(-1, 1)(random);
        const double largest = std::max(0.0, *std::ranges::max_element(values));
        const std::size_t valuesOfTask = 1 + random() % 300;
        ASSERT_EQ(largestInParallel(values.size(), valuesOfTask, [&](std::size_t k) { return values[k]; }),
                  largest);
    }
}

TEST(Parallel, StaysOnThisThreadWhereThatIsWanted) {
    std::vector<std::thread::id> threads(2000);
    onThisThread([&] {
        inParallel(threads.size(), [&](std::size_t k) {
            volatile double work = 0;
            for (int i = 0; i < 20'000; ++i)
                work = work + i; // long enough for others to take a part
            threads[k] = std::this_thread::get_id();
        });
    });
    EXPECT_EQ(std::ranges::count(threads, std::this_thread::get_id()), 2000);
}

TEST(Parallel, LoopsInLoops) {
    std::vector<std::vector<int>> table(40, std::vector<int>(60));
    inParallel(table.size(), [&](std::size_t row) {
        inParallel(table[row].size(), [&, row](std::size_t column) { table[row][column] = 1; });
        EXPECT_EQ(std::accumulate(table[row].begin(), table[row].end(), 0), 60);
    });
}

TEST(Parallel, ThrowsWhatTheBodyThrows) {
    EXPECT_THROW(inParallel(1000,
                            [](std::size_t k) {
                                if (k == 500)
                                    throw std::runtime_error("500");
                            }),
                 std::runtime_error);
}

} // namespace
} // namespace proveout
