// SPDX-License-Identifier: GPL-3.0-or-later
// Questions that several panels ask about a program.
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

/// The tool changes of a program, ascending by block; of more than kMostMarks one in each of so many equal
/// stretches of the program.
inline constexpr std::size_t kMostMarks = 4096;
[[nodiscard]] std::vector<ToolChangeMark> toolChangeMarks(const Program& program);

/// The block of the nearest tool change before (`direction` < 0) or behind (> 0) `block`; none where there is
/// no such.
[[nodiscard]] std::optional<std::size_t> neighbouringToolChange(const Program& program, std::size_t block,
                                                                int direction);

/// The index of the block that holds motion `motion`; blockCount() for one behind the last.
[[nodiscard]] std::size_t blockOfMotion(const Program& program, std::size_t motion);

/// What all motions that cut by intention (feeds and arcs, no rapids) reach together. Value type.
struct CuttingExtent {
    /// The numbers that they name, ascending, each once; 0: T0, or none (ToolChoice::tool()).
    std::vector<int> tools;
    Box3 box; ///< of the motions that are wholly known; mm
    /// Where the stock has its top, program coordinates, mm: at the Z0 of the work offset where something is
    /// cut below it, else at the highest of the motions, rounded up. Of several work offsets, the highest.
    double top = 0;
};

/// Goes through all motions: not for the UI thread.
[[nodiscard]] CuttingExtent cuttingExtent(const Program& program);

/// The stock that holds the cutting motions of a program: the cutter's radius wider than they are, 5 mm
/// deeper than the deepest of them. Rounded outwards to whole mm. `present` where nothing is cut.
[[nodiscard]] StockBox fittedStock(const CuttingExtent& cutting, const Setup& present,
                                   const ToolChoice& choice);

} // namespace proveout
