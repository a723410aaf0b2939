// SPDX-License-Identifier: GPL-3.0-or-later
// What the panel of the design part says. UI thread.
#pragma once

#include <string>

#include <QString>

#include "core/verification/part/part_comparison.h"

namespace proveout {

/// Decimals of lengths, and of areas and volumes.
inline constexpr int kLengthDecimals = 3;
inline constexpr int kSizeDecimals = 2;

/// "Gouge" or "Excess".
[[nodiscard]] QString kindName(IslandKind kind);
/// Why an island has no block.
[[nodiscard]] QString causeText(const ComparedIsland& island);
/// A sentence about an island, its size and its place.
[[nodiscard]] QString islandText(const ComparedIsland& island);
/// Whether the part is right, and what is not.
[[nodiscard]] QString resultText(const PartComparison& comparison);

/// The islands as CSV: a line of keys, then one line each; with decimal points in any locale.
[[nodiscard]] std::string islandsCsv(const PartComparison& comparison);

} // namespace proveout
