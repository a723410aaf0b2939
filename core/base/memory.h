// SPDX-License-Identifier: GPL-3.0-or-later
// Memory is computed before it is taken.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace proveout {

/// Where the system tells of memory; tests have folders of their own.
struct MemorySources {
    std::filesystem::path proc = "/proc";
    std::filesystem::path controlGroups = "/sys/fs/cgroup";
};

/// Bytes that this process can take now without swapping: the least of what the machine has available
/// (a cautious guess where the system does not say), of what is left in each of its control groups, and of
/// what its resource limits (`ulimit -v`, `ulimit -d`) leave beside what its threads reserve.
[[nodiscard]] std::uint64_t availableMemoryBytes(const MemorySources& sources = {});

/// Bytes that a job may take: what is available, and never more than half of what is installed or the control
/// groups allow, so that the machine stays usable. Ask before allocating. Takes some 100 µs.
[[nodiscard]] std::uint64_t memoryLimitBytes(const MemorySources& sources = {});

/// The largest resident size of this process so far; 0 where the system does not tell.
[[nodiscard]] std::uint64_t peakMemoryBytes();

/// Large blocks go back to the system as soon as they are freed, also once many of them were: glibc would
/// keep up to 32 MB in pieces, by which small maps took 1.6 times their forecast. To be called first in a
/// program.
void returnLargeBlocksAtOnce();

/// Gives memory that was freed in small pieces back to the system, so that it does not add to what is taken
/// next in large ones. Some 0.1 s a gigabyte.
void returnFreedMemory();

/// "1.5 GB", "320 MB": decimal units, for sentences.
[[nodiscard]] std::string readableBytes(double bytes);

} // namespace proveout
