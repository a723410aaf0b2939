// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core/base/persistent_array.h"
#include "core/nc/program/program.h"
#include "core/simulation/run/statistics.h"
#include "core/simulation/setup/machine.h"
#include "core/simulation/setup/setup.h"
#include "core/simulation/setup/tool_choice.h"
#include "core/simulation/time/machine_time.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// A program that has been run to its end, or will be. References to what the caller keeps; any thread.
struct CheckedRun {
    const Program& program;
    const Setup& setup;
    const ToolChoice& tools;
    const Machine* machine; ///< null: not given, and nothing is judged by it
    const MachineTimes& times;
    /// One for each block that was executed, recorded if it is among the needed records.
    const PersistentArray<BlockStatistics>& rows;
    const ZMapSnapshot* begin; ///< the uncut stock; null: not kept
    const ZMapSnapshot& end;   ///< the stock that is left
    double removedMm3;

    [[nodiscard]] bool isDone() const { return rows.size() == program.blockCount(); }
    [[nodiscard]] bool isRecorded(std::size_t block) const {
        return block < rows.size() && rows[block].isRecorded();
    }
    /// The cutter of a block, and its number: that of its last motion. Null: it has none.
    [[nodiscard]] const Cutter* cutterOf(std::size_t block) const { return setup.tools.find(toolOf(block)); }
    [[nodiscard]] int toolOf(std::size_t block) const {
        return tools.tool(program.motion(program.blockMotions(block).last - 1).tool);
    }
};

} // namespace proveout
