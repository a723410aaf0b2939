// SPDX-License-Identifier: GPL-3.0-or-later
// The cost of a run on this machine: counted work times fitted coefficients.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "core/study/study_run.h"

namespace proveout {

/// The measurement of one piece of work: seconds = Σ coefficient × work. Value type.
struct CostSample {
    static constexpr std::size_t kTerms = 3;

    std::array<double, kTerms> work{};
    double seconds = 0;
};
using Coefficients = std::array<double, CostSample::kTerms>;

/// Least squares with no coefficient below zero: every set of terms is tried, so the result is optimal.
/// Samples far off all others (when other work used the machine) are excluded from a second fit. Terms that
/// no sample can distinguish get 0.
[[nodiscard]] Coefficients fitCost(std::span<const CostSample> samples);

/// Seconds measured and seconds fitted, to be summed over fits that share a machine: where other work uses
/// the processor now and then, the samples that it affects are far off and excluded from a fit, but a run
/// will be affected as often.
struct Slowdown {
    double measured = 0;
    double fitted = 0;

    void add(std::span<const CostSample> samples, const Coefficients& coefficients);
    /// The factor for the coefficients; 1 if nothing was fitted.
    [[nodiscard]] double factor() const { return fitted > 0 ? measured / fitted : 1; }
};
[[nodiscard]] Coefficients scaled(const Coefficients& coefficients, double factor);

/// Coefficients of one machine, program, stock, grid, allowance and method.
struct CostModel {
    /// Seconds per moment, region and triangle made; for one region size, because with larger regions a
    /// region's storage no longer fits the caches.
    struct Decimation {
        double perStartRegion = 0;
        Coefficients perMomentRegionFace{};
    };

    double cutSeconds = 0;                   ///< of the whole program, independent of the decimation
    Coefficients drawPerFrameFaceRegion{};   ///< seconds per frame, triangle shown, region shown
    Coefficients uploadPerFrameFaceRegion{}; ///< seconds per frame, triangle made, region shown
    std::map<int, Decimation> decimation;    ///< by region size

    /// The cost of a run, seconds. Its region size must have been fitted, unless nothing was decimated.
    [[nodiscard]] double cost(const WorkCount& count, int regionCells) const;
};

} // namespace proveout
