// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>

#include "core/base/diagnostic.h"
#include "core/simulation/run/frame.h"

namespace proveout::cli {

inline constexpr std::uint64_t kLeastRecordBytes = 30; ///< of one row

/// Writes one row per executed motion block, atomically: block (1-based), source line and its statistics; mm,
/// mm³ and seconds. `cuts` and `firstContact` are 0 or 1; `rateMm3PerMin` is empty if the feed rate of the
/// block is unknown.
[[nodiscard]] Result<void> writeRecords(const std::filesystem::path& file, const Frame& frame);

} // namespace proveout::cli
