// SPDX-License-Identifier: GPL-3.0-or-later
// The problems of the session together with the findings of its check. Thread: UI.
#pragma once

#include <vector>

#include "core/base/diagnostic.h"
#include "core/verification/check/check_report.h"

namespace proveout {

class Session;

/// One entry for all equal messages, with their number. The findings of a check replace those of the blocks
/// that were played, because it has seen all blocks.
[[nodiscard]] std::vector<CheckFinding> problemList(const Session& session);

/// While a result is awaited: what the check before the last change has found besides the text, without what
/// is known to be there still. It may be gone, and its lines may be others. Empty otherwise.
[[nodiscard]] std::vector<CheckFinding> outdatedProblems(const Session& session,
                                                         const std::vector<CheckFinding>& known);

/// The finding of a report with this diagnostic; null if there is none.
[[nodiscard]] const CheckFinding* findingOf(const CheckReport& report, const Diagnostic& diagnostic);

/// The problems with a line of the open text, for marks at their lines: those of the session, which has one
/// for each block that was played, and what else the check has found. `block`: 0 if only the line is known.
[[nodiscard]] std::vector<CheckFinding> problemsInText(const Session& session);

} // namespace proveout
