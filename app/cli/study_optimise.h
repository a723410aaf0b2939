// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <nlohmann/json.hpp>

#include "core/study/optimiser.h"

namespace proveout::cli {

/// The result of `study --optimise`.
struct Optimised {
    struct Exhaustive {
        Forecast best;        ///< best of all points, from the counts of direct runs
        double chosenSeconds; ///< of the chosen point, from such counts
        double countSeconds;  ///< wall time of all direct runs, without drawing
        Measured bestMeasured;
    };

    DecimationParameters given;
    Rehearsal rehearsal;
    Measured chosenMeasured;
    Measured givenMeasured;
    std::optional<Exhaustive> exhaustive;

    /// Chooses, then runs the chosen and the given parameters alternately (and the best point if
    /// `exhaustive`).
    [[nodiscard]] static Result<Optimised> of(const StudyJob& job, const DecimationParameters& given,
                                              const SweepOptions& measuring, bool exhaustive);

    [[nodiscard]] nlohmann::ordered_json json() const;
    void print() const;
};

} // namespace proveout::cli
