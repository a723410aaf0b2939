// SPDX-License-Identifier: GPL-3.0-or-later
// What a run costs on this machine: counted work times coefficients that were fitted.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "core/study/study_run.h"

namespace proveout {

/// What was measured of one piece of work: seconds = Σ coefficient × work. Value type.
struct CostSample {
    static constexpr std::size_t kTerms = 3;

    std::array<double, kTerms> work{};
    double seconds = 0;
};
using Coefficients = std::array<double, CostSample::kTerms>;

/// Least squares with no coefficient below zero: every set of terms is tried, so the result is the best there
/// is. Samples far off all others (something else had the machine) are left out of a second fit. Terms that
/// no sample can tell apart get 0.
[[nodiscard]] Coefficients fitCost(std::span<const CostSample> samples);

/// Seconds measured and seconds fitted, to be added up over fits that share a machine: where other work takes
/// the processor now and then, the samples it hit are far off and left out of a fit, but a run will be hit as
/// often.
struct Slowdown {
    double measured = 0;
    double fitted = 0;

    void add(std::span<const CostSample> samples, const Coefficients& coefficients);
    /// What coefficients are to be multiplied by; 1 where nothing was fitted.
    [[nodiscard]] double factor() const { return fitted > 0 ? measured / fitted : 1; }
};
[[nodiscard]] Coefficients scaled(const Coefficients& coefficients, double factor);

/// Coefficients of one machine, program, stock, grid, allowance and method.
struct CostModel {
    /// Seconds by moment, region and triangle made; of one region size, because a region's storage grows out
    /// of the caches.
    struct Decimation {
        double perStartRegion = 0;
        Coefficients perMomentRegionFace{};
    };

    double cutSeconds = 0;                   ///< of the whole program, whatever is decimated
    Coefficients drawPerFrameFaceRegion{};   ///< seconds by frame, triangle shown, region shown
    Coefficients uploadPerFrameFaceRegion{}; ///< seconds by frame, triangle made, region shown
    std::map<int, Decimation> decimation;    ///< by region size

    /// The cost of a run, seconds. Its region size must have been fitted, unless nothing was decimated.
    [[nodiscard]] double cost(const WorkCount& count, int regionCells) const;
};

} // namespace proveout
