// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/motions/radius_notice.h"

#include <utility>

#include "core/nc/state/execution.h"

namespace proveout {

void reportOfRadius(Execution& execution, const FindingRow& message, const Word& word,
                    std::vector<Argument> arguments) {
    if (execution.state.compensation.assumed)
        execution.reporter.reportAsWarning(message, word, std::move(arguments));
    else
        execution.reporter.report(message, word, std::move(arguments));
}

} // namespace proveout
