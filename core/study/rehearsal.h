// SPDX-License-Identifier: GPL-3.0-or-later
// A short rehearsal of a program: the cost of every region size and period, without running them.
#pragma once

#include <vector>

#include "core/study/cost_model.h"
#include "core/study/draw_cost.h"
#include "core/study/study_run.h"

namespace proveout {

/// A region size and a period, with their expected cost.
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
    double seconds = 0; ///< the time of the rehearsal
};

/// The candidates of a rehearsal.
struct RehearsalOptions {
    std::vector<int> regions;
    std::vector<int> periods; ///< without 0
    int samples = 16;         ///< minimum number of moments at which regions are decimated, drawn and
                              ///< measured
};

/// The sizes and periods that the optimiser chooses from, for this job: no region larger than the map, no
/// more regions than the memory permits, no period longer than the program.
[[nodiscard]] RehearsalOptions rehearsalFor(const StudyJob& job);

/// Cuts the program once and follows which regions it touches: moments, frames, and dirty regions of all
/// schedules are then known exactly. At some blocks, a random few of the touched regions are decimated, and
/// frames of some region sizes are drawn: these measurements give the triangles of decimated regions and the
/// coefficients of the cost. Allowance and method come from `base`. Errors: stock, grid and memory as for
/// Simulation::create(); "nothing-to-optimise" if the method does not decimate region by region, or the
/// allowance is 0; "study-stopped".
[[nodiscard]] Result<Rehearsal> rehearse(const StudyJob& job, const DecimationParameters& base,
                                         const RehearsalOptions& options, DrawCost& drawing,
                                         const WorkContext& context = {});

} // namespace proveout
