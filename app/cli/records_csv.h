// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>

#include "core/base/diagnostic.h"
#include "core/simulation/run/frame.h"

namespace proveout::cli {

inline constexpr std::uint64_t kLeastRecordBytes = 30; ///< of a row

/// Writes one row per executed block that moves, atomically: block (1-based), source line and its statistics;
/// mm, mm³ and seconds. `cuts` and `firstContact` are 0 or 1; `rateMm3PerMin` is empty where the feed of the
/// block is not known.
[[nodiscard]] Result<void> writeRecords(const std::filesystem::path& file, const Frame& frame);

} // namespace proveout::cli
