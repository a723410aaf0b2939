// SPDX-License-Identifier: GPL-3.0-or-later
// The seed of tests over random input. Any thread.
#pragma once

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

} // namespace proveout
