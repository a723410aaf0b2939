// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/thread_priority.h"

#include <gtest/gtest.h>
#include <thread>

#ifdef __linux__
#include <sys/resource.h>

namespace proveout {
namespace {

int niceness() {
    return getpriority(PRIO_PROCESS, 0); // on Linux of the calling thread
}

TEST(ThreadPriority, OfOneThreadIsLowered) {
    const int before = niceness();
    int lowered = 0;
    std::jthread([&] {
        lowerThreadPriority();
        lowered = niceness();
    }).join();
    EXPECT_EQ(lowered, 15);
    EXPECT_EQ(niceness(), before);
}

} // namespace
} // namespace proveout
#endif
