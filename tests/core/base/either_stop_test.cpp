// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/either_stop.h"

#include <gtest/gtest.h>
#include <thread>

namespace proveout {
namespace {

TEST(EitherStop, FollowsEachRequest) {
    for (const bool first : {true, false}) {
        std::stop_source one;
        std::stop_source other;
        const EitherStop either(one.get_token(), other.get_token());
        EXPECT_FALSE(either.token().stop_requested());
        (first ? one : other).request_stop();
        EXPECT_TRUE(either.token().stop_requested());
    }
}

TEST(EitherStop, IsStoppedByAnEarlierRequest) {
    std::stop_source one;
    one.request_stop();
    EXPECT_TRUE(EitherStop(one.get_token(), {}).token().stop_requested());
    EXPECT_TRUE(EitherStop({}, one.get_token()).token().stop_requested());
    EXPECT_FALSE(EitherStop({}, {}).token().stop_requested());
}

TEST(EitherStop, MayEndWhileItIsRequested) {
    for (int round = 0; round < 200; ++round) {
        std::stop_source one;
        std::jthread requester([&] { one.request_stop(); });
        const EitherStop either(one.get_token(), {});
    }
}

} // namespace
} // namespace proveout
