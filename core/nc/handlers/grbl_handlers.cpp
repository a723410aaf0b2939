// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/codes/handlers.h"
#include "core/nc/state/execution.h"

namespace proveout {

void ignoreOptionalStop(Execution& execution, const Word& word) {
    execution.reporter.report(nc_message::kOptionalStopIgnored, word);
}

void switchMistWhereBuilt(Execution& execution, const Word& word) {
    execution.reporter.report(nc_message::kMistOption, word);
    switchMistOn(execution, word);
}

} // namespace proveout
