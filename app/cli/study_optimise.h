// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <nlohmann/json.hpp>

#include "core/study/optimiser.h"

namespace proveout::cli {

/// What `study --optimise` found out.
struct Optimised {
    struct Exhaustive {
        Forecast best;        ///< of all points, by counts of straight runs
        double chosenSeconds; ///< of the chosen point, by such counts
        double countSeconds;  ///< wall time of all straight runs, without drawing
        Measured bestMeasured;
    };

    DecimationParameters given;
    Rehearsal rehearsal;
    Measured chosenMeasured;
    Measured givenMeasured;
    std::optional<Exhaustive> exhaustive;

    /// Chooses, then runs the chosen and the given parameters in turns (and the best, where `exhaustive`).
    [[nodiscard]] static Result<Optimised> of(const StudyJob& job, const DecimationParameters& given,
                                              const SweepOptions& measuring, bool exhaustive);

    [[nodiscard]] nlohmann::ordered_json json() const;
    void print() const;
};

} // namespace proveout::cli
