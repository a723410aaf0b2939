// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core/simulation/run/cut_ahead.h"
#include "core/simulation/run/simulation_state.h"

namespace proveout {

/// Executes blocks with their schedule like step() for one after the other, with the same rows and surface.
/// But the surface of some moments is made at once, on all threads, while the blocks after them are cut: two
/// or three regions, as in a usual moment, are not worth waking other threads. Owned by one thread.
class PlayAhead {
public:
    /// Executes every block before `block` that was not played, and moves there.
    static void play(Simulation::State& state, std::size_t block, const WorkContext& context);

    /// `state` is settled; none of the blocks from its position to `last` has been played.
    PlayAhead(Simulation::State& state, std::size_t last);

    /// After a stop, or if the surface needs too much memory, the blocks that have been cut count as
    /// executed; those whose surface is missing have rows without times, and the surface is unsettled.
    void run(const WorkContext& context);

private:
    [[nodiscard]] CutStretch cutStretch(const WorkContext& context);
    void make(CutStretch& stretch, const CutStretch::Job& job, const std::stop_token& stop) const;
    [[nodiscard]] bool show(CutStretch& stretch, double share);
    void show(CutStretch::Block& block, CutStretch::Moment* moment, double share);
    void keepUnshown(const CutStretch& stretch);
    void fallBehind();

    Simulation::State& m_state;
    std::size_t m_last;
    std::size_t m_shown; ///< blocks before it are in rows and surface
    CutFront m_front;
};

} // namespace proveout
