// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/persistent_array.h"
#include "core/base/work_context.h"
#include "core/nc/program/program.h"
#include "core/simulation/run/block_set.h"
#include "core/simulation/run/checkpoints.h"
#include "core/simulation/run/statistics.h"
#include "core/simulation/setup/setup.h"
#include "core/simulation/setup/tool_choice.h"

namespace proveout {

/// Adds to the rows of these blocks the records that cutBlock() makes of them, to the last bit. `from` is a
/// moment before the first of them. Other motions are cut only where they come near one of these blocks: some
/// 100 ns each if there are few. False if it was stopped: some are missing. The calling thread, and others
/// inside.
[[nodiscard]] bool recordBlocks(PersistentArray<BlockStatistics>& rows, const BlockSet& blocks,
                                const Checkpoint& from, const Program& program, const Setup& setup,
                                const ToolChoice& tools, const WorkContext& context);

} // namespace proveout
