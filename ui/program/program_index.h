// SPDX-License-Identifier: GPL-3.0-or-later
// Queries about a program that several panels need.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/base/geometry.h"
#include "core/nc/program/program.h"
#include "core/simulation/setup/setup.h"
#include "core/simulation/setup/tool_choice.h"

namespace proveout {

struct ToolChangeMark {
    std::size_t block = 0; ///< blocks executed before the change
    int tool = 0;
};

/// The tool changes of a program, ascending by block. If there are more than kMostMarks, the program is
/// divided into that many equal parts and one change of each part is returned.
inline constexpr std::size_t kMostMarks = 4096;
[[nodiscard]] std::vector<ToolChangeMark> toolChangeMarks(const Program& program);

/// The block of the nearest tool change before (`direction` < 0) or after (> 0) `block`; empty if there is
/// none.
[[nodiscard]] std::optional<std::size_t> neighbouringToolChange(const Program& program, std::size_t block,
                                                                int direction);

/// The index of the block that contains motion `motion`; blockCount() for a motion after the last one.
[[nodiscard]] std::size_t blockOfMotion(const Program& program, std::size_t motion);

/// The extent of all cutting motions (feeds and arcs, no rapids). Value type.
struct CuttingExtent {
    /// The tool numbers of these motions, ascending, without duplicates; 0: T0 or no tool
    /// (ToolChoice::tool()).
    std::vector<int> tools;
    Box3 box; ///< of the motions that are completely known; mm
    /// Height of the stock's top, program coordinates, mm: Z0 of the work offset if something is cut below
    /// it, otherwise the highest motion, rounded up. With several work offsets, the highest result.
    double top = 0;
};

/// Visits all motions, so do not call it on the UI thread.
[[nodiscard]] CuttingExtent cuttingExtent(const Program& program);

/// The stock that contains the cutting motions of a program, wider by the cutter's radius and 5 mm deeper
/// than the deepest of them. Rounded outwards to whole mm. `present` if nothing is cut.
[[nodiscard]] StockBox fittedStock(const CuttingExtent& cutting, const Setup& present,
                                   const ToolChoice& choice);

} // namespace proveout
