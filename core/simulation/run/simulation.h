// SPDX-License-Identifier: GPL-3.0-or-later
// The simulator: blocks in, z-map, surface and records out (paper §3).
#pragma once

#include <cstddef>
#include <memory>

#include "core/base/work_context.h"
#include "core/simulation/run/frame.h"
#include "core/simulation/setup/tool_choice.h"

namespace proveout {

/// Runs one program on one stock. Owned by one thread. The state after block n depends on program, set-up and
/// parameters only, never on how one got there: z-map bit for bit, and the surface by the logical schedule
/// (at every s-th block that moves the dirty regions are decimated).
class Simulation {
public:
    /// Takes the memory (asked for first); decimating the uncut stock (paper §3, step 1) is left to
    /// `seek(0)`, whose context can stop it. Errors: stock, grid, memory, parameters out of range.
    [[nodiscard]] static Result<std::unique_ptr<Simulation>> prepare(std::shared_ptr<const Program> program,
                                                                     std::shared_ptr<const Setup> setup,
                                                                     const DecimationParameters& parameters);
    /// prepare(), and the uncut stock decimated. A stopped context leaves the surface unsettled.
    [[nodiscard]] static Result<std::unique_ptr<Simulation>> create(std::shared_ptr<const Program> program,
                                                                    std::shared_ptr<const Setup> setup,
                                                                    const DecimationParameters& parameters,
                                                                    const WorkContext& context = {});
    ~Simulation();
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;

    [[nodiscard]] std::size_t position() const; ///< blocks executed
    [[nodiscard]] std::size_t blockCount() const;
    [[nodiscard]] const Program& program() const;
    [[nodiscard]] bool atEnd() const { return position() == blockCount(); }

    /// Whether the surface is where the schedule has it; false only after a stopped context, or where a
    /// change is noted that `seek(position())` has not carried out yet.
    [[nodiscard]] bool settled() const;

    /// Executes the next block; nothing at the end. A stopped context may leave the surface unsettled, or do
    /// nothing.
    void step(const WorkContext& context = {});
    /// Goes to the state after block `block` (clamped), from a checkpoint where that is nearer. Blocks that
    /// were never executed run through the whole schedule, so that their statistics are true. A stopped
    /// context ends at another valid block, or leaves the surface unsettled: regions are drawn from the z-map
    /// until the next call, `seek(position())` at the latest, decimates them.
    void seek(std::size_t block, const WorkContext& context = {});
    /// Notes other parameters, without the work for them: `seek(position())` brings the surface to where the
    /// schedule has it with them. Statistics so far stay, but for the row of this block. Parameters out of
    /// range are ignored.
    void noteParameters(const DecimationParameters& parameters);
    /// Notes an edited program, without cutting anything: everything before the first block that differs is
    /// kept. Returns where to go on, the old position or the last block kept, whichever is smaller; the
    /// position is there or at an earlier block, from which `seek` goes there.
    [[nodiscard]] std::size_t noteProgram(std::shared_ptr<const Program> program);
    /// Bytes for checkpoints; the oldest detail is thinned out beyond them. 0: none are kept but the uncut
    /// stock, for runs that only go forward.
    void setCheckpointBudget(std::size_t bytes);

    /// Whether refine() has anything to do: the certified method shows its surface at the level asked for,
    /// and merges regions, while nothing is cut.
    [[nodiscard]] bool canRefine() const;
    /// Makes the surface that frame() shows until the next block; it is a function of z-map and parameters
    /// too. Statistics tell of the surface by the schedule. A stopped context leaves the latter shown, and so
    /// does a lack of memory.
    void refine(const WorkContext& context = {});

    /// The surface of this moment with every region decimated, whatever the schedule, by forExport(). Does
    /// not change the simulation.
    [[nodiscard]] SurfaceSnapshot decimatedNow(const WorkContext& context = {}) const;
    [[nodiscard]] ZMapSnapshot zmap() const;
    /// Which tools its program cuts with.
    [[nodiscard]] const ToolChoice& tools() const;
    /// Wall time spent so far, replays included.
    struct Effort {
        double allocateSeconds = 0;
        double cutSeconds = 0;
        double decimationSeconds = 0;
        std::size_t blocksCut = 0; ///< also those of replays
    };
    [[nodiscard]] Effort effort() const;
    /// One row a block that was ever executed.
    [[nodiscard]] const PersistentArray<BlockStatistics>& rows() const;
    /// Whether anything was found at block `block` (0-based).
    [[nodiscard]] bool foundAt(std::size_t block) const;
    /// A frame of this moment; generation and sequence are left 0.
    [[nodiscard]] Frame frame() const;

private:
    struct State;
    explicit Simulation(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

} // namespace proveout
