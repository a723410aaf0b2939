// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <set>

#include "core/base/geometry.h"
#include "core/cutter/tool_table.h"
#include "core/cutting/fixtures/fixture.h"
#include "core/nc/text/dialect.h"
#include "core/zmap/stock_shape.h"

namespace proveout {

/// What is on the machine before the program runs. Value type.
struct Setup {
    StockBox stock;             ///< the box around it
    StockShape shape;           ///< which part of that box is material
    double spacing = 1;         ///< requested grid spacing, mm; for an automatic grid: the one computed last
    bool automaticGrid = false; ///< the spacing follows stock and cutters (automatic_grid.h)
    ToolTable tools;
    Fixtures fixtures;         ///< nothing cuts them; checked after a run
    std::optional<Vec3> start; ///< position of the cutter before the first block, if it is known
    /// The tool in the spindle before the first block, if it is known. 0: none, or T0 of the table.
    std::optional<int> startTool;
    std::optional<DialectId> dialect; ///< of the program; nothing: detected from its text
    bool blockDelete = false;         ///< skip blocks that begin with "/"
    bool compensationTypeB = false;   ///< InterpretOptions
    std::set<int> ignoredM = {};      ///< InterpretOptions

    friend bool operator==(const Setup&, const Setup&) = default;
};

} // namespace proveout
