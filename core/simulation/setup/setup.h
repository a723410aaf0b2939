// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <set>

#include "core/base/geometry.h"
#include "core/cutter/tool_table.h"
#include "core/nc/text/dialect.h"
#include "core/zmap/stock_shape.h"

namespace proveout {

/// What stands on the machine before the program runs. Value type.
struct Setup {
    StockBox stock;     ///< the box round it
    StockShape shape;   ///< what of that box there is
    double spacing = 1; ///< wanted grid spacing, mm; of an automatic grid: the one that was found last
    bool automaticGrid = false; ///< the spacing follows stock and cutters (automatic_grid.h)
    ToolTable tools;
    std::optional<Vec3> start; ///< position of the cutter before the first block, if it is known
    /// The tool in the spindle before the first block, if it is known. 0: none, or T0 of the table.
    std::optional<int> startTool;
    std::optional<DialectId> dialect; ///< of the program; nothing: by the signs in its text
    bool blockDelete = false;         ///< skip blocks that begin with "/"
    bool compensationTypeB = false;   ///< InterpretOptions
    std::set<int> ignoredM = {};      ///< InterpretOptions

    friend bool operator==(const Setup&, const Setup&) = default;
};

} // namespace proveout
