// SPDX-License-Identifier: GPL-3.0-or-later
// What the control groups of Linux leave to this process: a container has less than its machine, and is
// killed at its own limit.
#pragma once

#include <cstdint>
#include <limits>

#include "core/base/memory.h"

namespace proveout {

/// Bytes; the largest number where nothing is limited.
struct GroupMemory {
    std::uint64_t limit = std::numeric_limits<std::uint64_t>::max();     ///< the least one
    std::uint64_t available = std::numeric_limits<std::uint64_t>::max(); ///< the least of limit less usage
};

/// The least over the groups of this process, of version 1 (controller `memory`) and of version 2, from its
/// own group up to the topmost that is visible: each of them limits all that is in it. Groups that are not
/// visible, as the own one from within a container, are skipped. Files that the system keeps in memory for
/// speed are not counted as used, because it gives them up when asked. Any thread.
[[nodiscard]] GroupMemory controlGroupMemory(const MemorySources& sources);

} // namespace proveout
