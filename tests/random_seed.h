// SPDX-License-Identifier: GPL-3.0-or-later
// The seed of tests over random input, and how much of it they try. Any thread.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>

namespace proveout {

/// A new one with every call, for tests to print; that of the variable PROVEOUT_SEED where it is set, so that
/// a failure is seen again and a run that gates a change depends on the change alone.
inline std::uint32_t randomSeed() {
    if (const char* chosen = std::getenv("PROVEOUT_SEED"))
        return static_cast<std::uint32_t>(std::stoul(chosen));
    return std::random_device{}();
}

/// Of `all` rounds of random input as many as a build tries: the share that the variable PROVEOUT_SHARE
/// tells, at least one. Sanitizers look for faults of memory and threads, which the first rounds have as well
/// as the last; CTest lets their builds do a part.
inline int roundsOf(int all) {
    const char* share = std::getenv("PROVEOUT_SHARE");
    return share == nullptr ? all : std::max(1, static_cast<int>(std::lround(all * std::stod(share))));
}

} // namespace proveout
