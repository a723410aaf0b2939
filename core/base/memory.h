// SPDX-License-Identifier: GPL-3.0-or-later
// How much memory may be allocated; it is checked before the allocation.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace proveout {

/// Where the system reports memory; tests use folders of their own.
struct MemorySources {
    std::filesystem::path proc = "/proc";
    std::filesystem::path controlGroups = "/sys/fs/cgroup";
};

/// Bytes that this process can allocate now without swapping: the smallest of what the machine has available
/// (a cautious guess where the system does not say), what is left in each of its control groups, and what its
/// resource limits (`ulimit -v`, `ulimit -d`) leave after the reservations of its threads.
[[nodiscard]] std::uint64_t availableMemoryBytes(const MemorySources& sources = {});

/// The same without the resource limits, which count the threads that run already.
[[nodiscard]] std::uint64_t machineMemoryBytes(const MemorySources& sources = {});

/// Bytes that a job may allocate: what is available, but never more than half of what is installed or what
/// the control groups allow, so that the machine stays usable. Ask before allocating. Takes some 100 µs.
[[nodiscard]] std::uint64_t memoryLimitBytes(const MemorySources& sources = {});

/// The resident size of this process now; 0 where the system does not report it.
[[nodiscard]] std::uint64_t residentMemoryBytes(const MemorySources& sources = {});

/// The largest resident size that this program has had; 0 where the system does not report it. Where it only
/// reports that of the process, the program that started this one counts too.
[[nodiscard]] std::uint64_t peakMemoryBytes(const MemorySources& sources = {});

/// Makes large blocks return to the system as soon as they are freed, however many of them there were:
/// otherwise glibc would keep up to 32 MB in pieces, by which small maps took 1.6 times their forecast. Call
/// it first in a program.
void returnLargeBlocksAtOnce();

/// Returns memory that was freed in small pieces to the system, so that it does not add to what is allocated
/// next in large ones. Some 0.1 s per gigabyte.
void returnFreedMemory();

/// "1.5 GB", "320 MB": decimal units, for use in sentences.
[[nodiscard]] std::string readableBytes(double bytes);

} // namespace proveout
