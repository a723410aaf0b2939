// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/setup/parameter_check.h"

#include <fmt/format.h>

#include "core/base/figures_argument.h"
#include "core/simulation/setup/setup_findings.h"

namespace proveout {

Result<void> checkRanges(const DecimationParameters& parameters) {
    Result<void> result;
    describe(parameters, [&result](const auto& value, const Field& field) {
        const auto number = static_cast<double>(value);
        if (hasRange(field) && !isInRange(field, number) && result)
            result = failure(setup_finding::kParameterOutOfRange,
                             {field.key, figures("{}", number), figures("{}", field.minimum),
                              figures("{}", field.maximum)});
    });
    return result;
}

} // namespace proveout
