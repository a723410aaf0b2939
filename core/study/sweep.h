// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "core/study/averages.h"
#include "core/study/study_run.h"

namespace proveout {

/// A point of a sweep with all its runs.
struct SweptPoint {
    StudyRun run;     ///< the run of the median total
    Measured seconds; ///< of the totals of all runs
};

struct SweepOptions {
    DrawCost* drawing = nullptr; ///< null: nothing is drawn
    std::size_t drawEvery = 1;   ///< as in runStudy()
    int repeats = 1;             ///< runs a point
    /// Called after each run of a point for the first time, on the thread of the sweep.
    std::function<void(const StudyRun&)> finished;
};

/// Runs all points, in rounds: each round runs every point once and begins with another one, so that what
/// else the machine does hits all of them alike. The counts of a point must be the same in all its runs, and
/// are. Errors: as runStudy().
[[nodiscard]] Result<std::vector<SweptPoint>> runSweep(const StudyJob& job,
                                                       std::span<const StudyPoint> points,
                                                       const SweepOptions& options,
                                                       const WorkContext& context = {});

} // namespace proveout
