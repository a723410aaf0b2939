// SPDX-License-Identifier: GPL-3.0-or-later
// A short rehearsal of a program: what every region size and period would cost, without running them.
#pragma once

#include <vector>

#include "core/study/cost_model.h"
#include "core/study/draw_cost.h"
#include "core/study/study_run.h"

namespace proveout {

/// A region size and a period, and what they are expected to cost.
struct Forecast {
    int regionCells = 0;
    int period = 0;
    WorkCount count;
    double seconds = 0;
};

struct Rehearsal {
    std::vector<Forecast> forecasts; ///< every region size with every period
    Forecast undecimated;            ///< an allowance of 0; region size and period 0
    CostModel model;
    double seconds = 0; ///< what the rehearsal took
};

/// What a rehearsal goes through.
struct RehearsalOptions {
    std::vector<int> regions;
    std::vector<int> periods; ///< without 0
    int samples = 16;         ///< moments at which regions are decimated, drawn and measured, at least
};

/// The sizes and periods that the optimiser chooses from, for this job: no region beyond the map, not more
/// regions than memory admits, no period beyond the program.
[[nodiscard]] RehearsalOptions rehearsalFor(const StudyJob& job);

/// Cuts the program once and follows which regions it touches: moments, frames, and dirty regions of all
/// schedules are then known exactly. At some blocks, a random few of the regions touched are decimated, and
/// frames of some region sizes are drawn: these measurements give the triangles of decimated regions and the
/// coefficients of the cost. `base` tells allowance and method. Errors:
/// stock, grid and memory as Simulation::create(); "nothing-to-optimise" where the method does not decimate
/// region by region, or the allowance is 0; "study-stopped".
[[nodiscard]] Result<Rehearsal> rehearse(const StudyJob& job, const DecimationParameters& base,
                                         const RehearsalOptions& options, DrawCost& drawing,
                                         const WorkContext& context = {});

} // namespace proveout
