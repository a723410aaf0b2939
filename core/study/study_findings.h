// SPDX-License-Identifier: GPL-3.0-or-later
// Findings of parameter studies.
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::study_finding {

inline constexpr FindingRow kStudyStopped{Severity::error,
                                          false,
                                          "study-stopped",
                                          PROVEOUT_TEXT("Core", "Study stopped"),
                                          PROVEOUT_TEXT("Core", "The study was stopped."),
                                          ""};
inline constexpr FindingRow kNothingToOptimise{
    Severity::error,
    false,
    "nothing-to-optimise",
    PROVEOUT_TEXT("Core", "Nothing to optimise"),
    PROVEOUT_TEXT("Core", "Only a method that decimates region by region, with an allowance above 0, has a "
                          "region size and a period to choose."),
    ""};

inline constexpr std::array kStudyRows{&kStudyStopped, &kNothingToOptimise};

} // namespace proveout::study_finding
