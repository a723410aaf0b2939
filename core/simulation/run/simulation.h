// SPDX-License-Identifier: GPL-3.0-or-later
// The simulator: executes blocks and makes z-map, surface and records (paper §3).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "core/base/work_context.h"
#include "core/simulation/run/block_set.h"
#include "core/simulation/run/finding_log.h"
#include "core/simulation/run/frame.h"
#include "core/simulation/setup/tool_choice.h"

namespace proveout {

class RimFinder;

/// Runs one program on one stock. Owned by one thread. The state after block n depends only on program, setup
/// and parameters, not on earlier steps and seeks: the z-map bit for bit, and the surface by the logical
/// schedule (at every s-th motion block the dirty regions are decimated).
class Simulation {
public:
    /// Allocates the memory after checking it; decimating the uncut stock (paper §3, step 1) is left to
    /// `seek(0)`, whose context can stop it. Errors: stock, grid, memory, parameters out of range.
    [[nodiscard]] static Result<std::unique_ptr<Simulation>> prepare(std::shared_ptr<const Program> program,
                                                                     std::shared_ptr<const Setup> setup,
                                                                     const DecimationParameters& parameters);
    /// prepare() followed by decimation of the uncut stock. A stopped context leaves the surface unsettled.
    [[nodiscard]] static Result<std::unique_ptr<Simulation>> create(std::shared_ptr<const Program> program,
                                                                    std::shared_ptr<const Setup> setup,
                                                                    const DecimationParameters& parameters,
                                                                    const WorkContext& context = {});
    ~Simulation();
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;

    [[nodiscard]] std::size_t position() const; ///< number of blocks executed
    [[nodiscard]] std::size_t blockCount() const;
    [[nodiscard]] const Program& program() const;
    [[nodiscard]] bool atEnd() const { return position() == blockCount(); }

    /// Whether the surface is in the state that the schedule requires; false only after a stopped context, or
    /// when a change has been noted that `seek(position())` has not applied yet.
    [[nodiscard]] bool settled() const;

    /// Executes the next block; nothing at the end. A stopped context may leave the surface unsettled, or do
    /// nothing.
    void step(const WorkContext& context = {});
    /// Moves to the state after block `block` (clamped), starting from a checkpoint if that is nearer. Only
    /// the surface of `block` is made: rows of blocks that were never executed have no times and no faces. A
    /// stopped context ends at another valid block, or leaves the surface unsettled: regions are drawn from
    /// the z-map until the next call, at the latest `seek(position())`, decimates them.
    void seek(std::size_t block, const WorkContext& context = {});
    /// The same, after step() of each block before it that was not played yet: all rows are complete.
    void play(std::size_t block, const WorkContext& context = {});
    /// Notes other parameters, without the work for them: `seek(position())` brings the surface into the
    /// state that the schedule requires with them. Existing statistics stay, except for the row of this
    /// block. Parameters out of range are ignored.
    void noteParameters(const DecimationParameters& parameters);
    /// Notes an edited program, without cutting anything: everything before the first block that differs is
    /// kept. Returns the block to continue from, the old position or the last block kept, whichever is
    /// smaller; the position is there or at an earlier block, from which `seek` moves there.
    [[nodiscard]] std::size_t noteProgram(std::shared_ptr<const Program> program);
    /// Bytes for checkpoints; beyond that they are packed and thinned out (Checkpoints). 0: only the uncut
    /// stock is kept, for runs that only move forward.
    void setCheckpointBudget(std::size_t bytes);

    /// How many bytes may be allocated from now on, instead of memoryLimitBytes() when it was prepared. With
    /// a larger surface all is drawn from the z-map until there are other parameters; a finding says so.
    void allowMemory(std::uint64_t bytes);

    /// Keeps records only of these blocks and findings of all, which makes cutting several times as fast:
    /// from now on, and for the first time before the first block is executed. Frames tell the removed volume
    /// nevertheless.
    void keepRecordsOf(BlockSet blocks);
    /// Adds the records of blocks that were executed without them: what comes near them is cut once more,
    /// from the nearest checkpoint. False if it was stopped: some may be missing.
    bool record(const BlockSet& blocks, const WorkContext& context = {});

    /// Whether refine() has anything to do: the certified method shows its surface at the requested level,
    /// and merges regions, while nothing is cut.
    [[nodiscard]] bool canRefine() const;
    /// Makes the refined surface that frame() shows until the next block, with the walls that `rims` finds
    /// (any moments may have been found before); it too is a function of z-map and
    /// parameters. Statistics always describe the surface of the schedule. With a stopped context or without
    /// enough memory the surface of the schedule remains visible.
    void refine(RimFinder& rims, const WorkContext& context = {});

    /// The surface at this position with every region decimated, independent of the schedule, with
    /// forExport() parameters. Does not change the simulation.
    [[nodiscard]] SurfaceSnapshot decimatedNow(const WorkContext& context = {}) const;
    [[nodiscard]] ZMapSnapshot zmap() const;
    /// Which tools its program cuts with.
    [[nodiscard]] const ToolChoice& tools() const;
    /// Wall time spent since the start, including replays.
    struct Effort {
        double allocateSeconds = 0;
        double cutSeconds = 0;
        double decimationSeconds = 0;
        std::size_t blocksCut = 0; ///< including those of replays
    };
    [[nodiscard]] Effort effort() const;
    /// One row per block that was ever executed.
    [[nodiscard]] const PersistentArray<BlockStatistics>& rows() const;
    /// Of the blocks that were ever executed.
    [[nodiscard]] const FindingLog& findings() const;
    /// A frame of this moment; generation and sequence remain 0.
    [[nodiscard]] Frame frame() const;

private:
    friend class PlayAhead;
    struct State;
    explicit Simulation(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

} // namespace proveout
