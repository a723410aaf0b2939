// SPDX-License-Identifier: GPL-3.0-or-later
// The seed of tests with random input, and how much input they try. Any thread.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>

namespace proveout {

/// A new seed with every call, for tests to print; if the variable PROVEOUT_SEED is set, its value, so that
/// failures can be reproduced and a run that gates a change depends on that change alone.
inline std::uint32_t randomSeed() {
    if (const char* chosen = std::getenv("PROVEOUT_SEED"))
        return static_cast<std::uint32_t>(std::stoul(chosen));
    return std::random_device{}();
}

/// The number of the `all` rounds of random input that a build runs: the share set in the variable
/// PROVEOUT_SHARE, at least one. Sanitizers search for memory and thread errors, which the first rounds show
/// as well as the last; CTest runs only a part with their builds.
inline int roundsOf(int all) {
    const char* share = std::getenv("PROVEOUT_SHARE");
    return share == nullptr ? all : std::max(1, static_cast<int>(std::lround(all * std::stod(share))));
}

} // namespace proveout
