// SPDX-License-Identifier: GPL-3.0-or-later
// A cancel may arrive at any moment between posting a command and executing it.
#include "core/simulation/thread/command_queue.h"

#include <gtest/gtest.h>

namespace proveout {
namespace {

TEST(CommandQueue, ACancelStopsTheWorkOfACommandThatWasNotTakenYet) {
    CommandQueue queue;
    queue.post(SeekCommand{7});
    queue.cancel();
    ASSERT_TRUE(queue.take().has_value());
    EXPECT_TRUE(queue.beginWork(false).stop_requested());
    EXPECT_TRUE(queue.endWork());
}

TEST(CommandQueue, ACancelOutlivesAWaitThatACommandEnds) {
    CommandQueue queue;
    ASSERT_FALSE(queue.take().has_value());
    queue.post(SeekCommand{7});
    queue.cancel();
    queue.wait(); // the thread had found the queue empty before the command arrived
    ASSERT_TRUE(queue.take().has_value());
    EXPECT_TRUE(queue.beginWork(false).stop_requested());
    EXPECT_TRUE(queue.endWork());
}

TEST(CommandQueue, ACancelStopsTheWorkOfACommandThatWasTaken) {
    CommandQueue queue;
    queue.post(SeekCommand{7});
    ASSERT_TRUE(queue.take().has_value());
    queue.cancel();
    EXPECT_TRUE(queue.beginWork(false).stop_requested());
    EXPECT_TRUE(queue.endWork());
}

TEST(CommandQueue, ACancelSaysNothingOfWhatIsAskedForAfterIt) {
    CommandQueue queue;
    queue.post(SeekCommand{7});
    queue.cancel();
    queue.post(SeekCommand{8});
    ASSERT_TRUE(queue.take().has_value());
    EXPECT_FALSE(queue.beginWork(false).stop_requested());
    EXPECT_FALSE(queue.endWork());
}

TEST(CommandQueue, ACancelOfNothingIsForgotten) {
    CommandQueue queue;
    queue.cancel();
    queue.post(SeekCommand{7});
    ASSERT_TRUE(queue.take().has_value());
    EXPECT_FALSE(queue.beginWork(false).stop_requested());
    EXPECT_FALSE(queue.endWork());
}

} // namespace
} // namespace proveout
