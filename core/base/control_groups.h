// SPDX-License-Identifier: GPL-3.0-or-later
// The memory that Linux control groups leave to this process: a container has less than its machine, and is
// killed at its own limit.
#pragma once

#include <cstdint>
#include <limits>

#include "core/base/memory.h"

namespace proveout {

/// Bytes; the largest number where nothing is limited.
struct GroupMemory {
    std::uint64_t limit = std::numeric_limits<std::uint64_t>::max();     ///< the smallest one
    std::uint64_t available = std::numeric_limits<std::uint64_t>::max(); ///< the smallest value of limit
                                                                         ///< minus usage
};

/// The smallest values over the groups of this process, of version 1 (controller `memory`) and of version 2,
/// from its own group up to the topmost visible one: each of them limits everything in it. Groups that are
/// not visible, such as the process's own group inside a container, are skipped. The file cache does not
/// count as used, because the system frees it on demand. Any thread.
[[nodiscard]] GroupMemory controlGroupMemory(const MemorySources& sources);

} // namespace proveout
