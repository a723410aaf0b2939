// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "ui/document/job_document.h"

namespace proveout {

/// What a step changes.
struct JobStepName {
    QString text;   ///< the field as its panel labels it, in the user's language; never empty
    int field = -1; ///< equal for steps in the same field; -1: several fields
};

/// Names the step from `before` to `after`.
[[nodiscard]] JobStepName jobStepName(const JobValues& before, const JobValues& after);

/// Whether setup, parameters and machine are the same by value.
[[nodiscard]] bool sameValues(const JobValues& a, const JobValues& b);

} // namespace proveout
