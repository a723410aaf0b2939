// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/motions/radius_notice.h"

#include <utility>

#include "core/nc/state/execution.h"

namespace proveout {

void tellOfRadius(Execution& execution, const FindingRow& message, const Word& word,
                  std::vector<Argument> arguments) {
    if (execution.state.compensation.assumed)
        execution.reporter.tellAsWarning(message, word, std::move(arguments));
    else
        execution.reporter.tell(message, word, std::move(arguments));
}

} // namespace proveout
