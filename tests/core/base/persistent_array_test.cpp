// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/persistent_array.h"

#include <gtest/gtest.h>
#include <random>
#include <thread>

#include "tests/random_seed.h"

namespace proveout {
namespace {

std::vector<int> contents(const PersistentArray<int>& array) {
    std::vector<int> out;
    for (std::size_t i = 0; i < array.size(); ++i)
        out.push_back(array[i]);
    return out;
}

TEST(PersistentArray, CopiesShareUntilOneOfThemIsWritten) {
    PersistentArray<int> array(600, 7);
    const auto copy = array;
    EXPECT_EQ(&array[0], &copy[0]);
    array.edit(0) = 8;
    EXPECT_EQ(copy[0], 7);
    EXPECT_NE(&array[0], &copy[0]);
    EXPECT_EQ(&array[300], &copy[300]) << "a chunk that was not written stays shared";

    const int* written = &array[0];
    array.edit(1) = 9;
    EXPECT_EQ(&array[0], written) << "an own chunk is written in place";
}

/// Any sequence of copies, edits, appends and truncations behaves like vectors that are copied completely.
TEST(PersistentArray, ActsLikeAVectorThatIsCopied) {
    const unsigned seed = randomSeed();
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto below = [&random](std::size_t n) { return static_cast<std::size_t>(random()) % n; };
    std::vector<PersistentArray<int>> arrays(4);
    std::vector<std::vector<int>> models(4);
    for (int step = 0; step < 20'000; ++step) {
        const auto a = below(4);
        const auto b = below(4);
        switch (below(10)) {
        case 0:
            arrays[a] = arrays[b];
            models[a] = models[b];
            break;
        case 1: {
            const auto size = below(models[a].size() + 2);
            arrays[a].truncate(size);
            models[a].resize(std::min(size, models[a].size()));
            break;
        }
        case 2:
            if (a != b) {
                arrays[a] = std::move(arrays[b]);
                models[a] = std::move(models[b]);
                arrays[b].clear();
                models[b].clear();
            }
            break;
        case 3:
        case 4:
        case 5:
            if (!models[a].empty()) {
                const auto i = below(models[a].size());
                arrays[a].edit(i) = step;
                models[a][i] = step;
            }
            break;
        default:
            for (int i = 0; i < 100; ++i) {
                arrays[a].push_back(step + i);
                models[a].push_back(step + i);
            }
        }
        ASSERT_EQ(arrays[a].size(), models[a].size());
        if (step % 50 == 0) {
            for (std::size_t k = 0; k < 4; ++k)
                ASSERT_EQ(contents(arrays[k]), models[k]) << "step " << step;
        }
    }
}

/// The simulation's use: one thread writes and publishes copies, others copy and read what was published.
TEST(PersistentArray, ReadersOfACopyNeverSeeTheWriter) {
    PersistentArray<int> array(1000, 0);
    const PersistentArray<int> published = array;
    std::vector<std::thread> readers;
    for (int r = 0; r < 3; ++r) {
        readers.emplace_back([&published] {
            for (int round = 0; round < 200; ++round) {
                const auto own = published; // NOLINT(performance-unnecessary-copy-initialization)
                for (std::size_t i = 0; i < own.size(); i += 100)
                    EXPECT_EQ(own[i], 0);
            }
        });
    }
    for (int round = 1; round < 200; ++round)
        array.edit(static_cast<std::size_t>(round) * 5) = round;
    for (auto& reader : readers)
        reader.join();
}

} // namespace
} // namespace proveout
