// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/cutting/cut/cutting.h"
#include "core/cutting/cut/sequence_cutter.h"
#include "core/nc/program/program.h"
#include "core/simulation/run/block_set.h"
#include "core/simulation/run/finding_log.h"
#include "core/simulation/setup/setup.h"
#include "core/simulation/setup/tool_choice.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// Cuts all motions of block `block` (0-based), each with its own tool; motions without a cutter cut nothing
/// (ToolChoice::missing() has reported this already). Findings are added to `findings`, unless it is null.
/// Called by the thread that owns `zmap`. If it is stopped, the map is as before the block, findings do not
/// include the block, and there is no record.
[[nodiscard]] std::optional<CutRecord> cutBlock(ZMap& zmap, const Program& program, std::size_t block,
                                                const Setup& setup, const ToolChoice& tools,
                                                FindingLog* findings, const std::stop_token& stop);

/// What it takes to cut many blocks together; kept from one portion of a program to the next, so that its
/// memory, up to 90 MB, is allocated once. Owned by one thread.
struct PortionCutting {
    SequenceCutter cutter;
    std::vector<CutterMotion> motions;
    std::vector<CutRecord> ofMotions;
    std::vector<CutRecord> ofBlocks;
};

/// Cuts the blocks [first, last) with the same heights, records and findings as cutBlock() for one after the
/// other, to the last bit, but many of their motions at once. One record per block, in `cutting`. If only
/// some blocks are `recorded`, the records of others lack what no finding needs: most of their motions are
/// cut for their heights alone, several times as fast. If it is stopped, the map is as before, findings do
/// not include these blocks, and there are no records.
[[nodiscard]] std::optional<std::span<const CutRecord>>
cutBlocksInTurn(ZMap& zmap, const Program& program, std::size_t first, std::size_t last, const Setup& setup,
                const ToolChoice& tools, FindingLog* findings, const std::stop_token& stop,
                PortionCutting& cutting, const BlockSet* recorded = nullptr);

/// All motions of the blocks [first, last), each with its cutter, or null if it cuts nothing, and marked by 1
/// + its block. The cutters are those of `setup`.
[[nodiscard]] std::vector<CutterMotion> cutterMotions(const Program& program, std::size_t first,
                                                      std::size_t last, const Setup& setup,
                                                      const ToolChoice& tools);

/// Visits the motions of a range of a program, made in the same way, but marked by 1 + their index.
void eachCutterMotion(const Program& program, Program::MotionRange range, const Setup& setup,
                      const ToolChoice& tools, const std::function<void(const CutterMotion&)>& visit);

/// Cuts the blocks [first, last) at once, where only heights are needed, with the same result as cutBlock().
/// False if it was stopped; the map is unchanged then.
[[nodiscard]] bool cutBlocks(ZMap& zmap, const Program& program, std::size_t first, std::size_t last,
                             const Setup& setup, const ToolChoice& tools, const std::stop_token& stop,
                             PortionCutting& cutting);

} // namespace proveout
