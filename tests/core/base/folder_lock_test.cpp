// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/folder_lock.h"

#include <atomic>
#include <gtest/gtest.h>
#include <thread>
#include <vector>

#include "core/base/atomic_file.h"
#include "tests/core/temporary_folder.h"

namespace proveout {
namespace {

/// Each process increments the number that it reads; without the lock some increments would be lost.
TEST(FolderLock, NothingThatAnotherHasWrittenIsLost) {
    const TemporaryFolder folder;
    folder.put("count", "0");
    std::vector<std::thread> threads;
    for (int thread = 0; thread < 4; ++thread)
        threads.emplace_back([&] {
            for (int i = 0; i < 20; ++i) {
                const FolderLock turn(folder.path());
                const int count = std::stoi(readFile(folder / "count").value());
                EXPECT_TRUE(writeFile(folder / "count", std::to_string(count + 1)));
            }
        });
    for (std::thread& thread : threads)
        thread.join();
    EXPECT_EQ(readFile(folder / "count").value(), "80");
    EXPECT_EQ(folder.entries(), 1U) << "a lock leaves no file";
}

TEST(FolderLock, ContinuesWhereTheTurnDoesNotCome) {
    const TemporaryFolder folder;
    const FolderLock first(folder.path());
    std::atomic<bool> through = false;
    std::thread([&] {
        const FolderLock second(folder.path());
        through = true;
    }).join();
    EXPECT_TRUE(through);
    const FolderLock nowhere(folder / "no-such-folder");
}

} // namespace
} // namespace proveout
