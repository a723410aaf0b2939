// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <gtest/gtest.h>
#include <random>

#include "tests/random_seed.h"

namespace proveout {

/// With random numbers whose seed is printed with each failure.
class RandomTest : public testing::Test {
protected:
    const std::uint32_t seed = randomSeed();
    std::mt19937 random{seed};
    const testing::ScopedTrace trace{__FILE__, __LINE__, testing::Message() << "seed " << seed};
};

} // namespace proveout
