// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/cutting/cut/cutting.h"
#include "core/nc/program/program.h"
#include "core/simulation/run/finding_log.h"
#include "core/simulation/setup/setup.h"
#include "core/simulation/setup/tool_choice.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// Cuts all motions of block `block` (0-based), each with its own tool; motions without a cutter cut nothing
/// (and ToolChoice::missing() has told so already). What is found goes to `findings`, unless it is null.
/// Called by the thread that owns `zmap`. Where it is stopped the map is what it was before the block,
/// findings are without it, and there is no record.
[[nodiscard]] std::optional<CutRecord> cutBlock(ZMap& zmap, const Program& program, std::size_t block,
                                                const Setup& setup, const ToolChoice& tools,
                                                FindingLog* findings, const std::stop_token& stop);

/// All motions of the blocks [first, last), each with its cutter, or none where it cuts nothing, and marked
/// by 1 + its block. The cutters are those of `setup`.
[[nodiscard]] std::vector<CutterMotion> cutterMotions(const Program& program, std::size_t first,
                                                      std::size_t last, const Setup& setup,
                                                      const ToolChoice& tools);

/// The blocks [first, last) at once, where only heights are wanted: the same as of cutBlock(). False where it
/// was stopped, and the map is what it was.
[[nodiscard]] bool cutBlocks(ZMap& zmap, const Program& program, std::size_t first, std::size_t last,
                             const Setup& setup, const ToolChoice& tools, const std::stop_token& stop);

} // namespace proveout
