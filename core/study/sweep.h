// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "core/study/averages.h"
#include "core/study/study_run.h"

namespace proveout {

/// A point of a sweep with the results of its runs.
struct SweptPoint {
    StudyRun run;     ///< the run of the median total
    Measured seconds; ///< of the totals of all runs
};

struct SweepOptions {
    DrawCost* drawing = nullptr; ///< null: nothing is drawn
    std::size_t drawEvery = 1;   ///< as in runStudy()
    int repeats = 1;             ///< runs per point
    /// Called after the first run of each point, on the thread of the sweep.
    std::function<void(const StudyRun&)> finished;
};

/// Runs all points, in rounds: each round runs every point once and begins with a different one, so that
/// other load on the machine affects all of them alike. The counts of a point are the same in all its runs.
/// Errors: as runStudy().
[[nodiscard]] Result<std::vector<SweptPoint>> runSweep(const StudyJob& job,
                                                       std::span<const StudyPoint> points,
                                                       const SweepOptions& options,
                                                       const WorkContext& context = {});

} // namespace proveout
