// SPDX-License-Identifier: GPL-3.0-or-later
// Memory is computed before it is taken.
#pragma once

#include <cstdint>
#include <string>

namespace proveout {

/// Bytes that the machine can give now without swapping; a cautious guess where the system does not tell.
[[nodiscard]] std::uint64_t availableMemoryBytes();

/// Bytes that a job may take: what is available, and never more than half of what is installed, so that the
/// machine stays usable. Ask before allocating.
[[nodiscard]] std::uint64_t memoryLimitBytes();

/// The largest resident size of this process so far; 0 where the system does not tell.
[[nodiscard]] std::uint64_t peakMemoryBytes();

/// "1.5 GB", "320 MB": decimal units, for sentences.
[[nodiscard]] std::string readableBytes(double bytes);

} // namespace proveout
