// SPDX-License-Identifier: GPL-3.0-or-later
// The checks that the rows of lint.cpp name.
#pragma once

#include "core/nc/run/lint.h"

namespace proveout::lint {

/// Records what later rules need to know about a block with codes.
void remember(const LintView& view);
[[nodiscard]] bool changesTool(const LintView& view);

void toolNotInTable(const LintView& view, const FindingRow& message);
void feedZero(const LintView& view, const FindingRow& message);
void lengthMissing(const LintView& view, const FindingRow& message);
void offsetNeverChosen(const LintView& view, const FindingRow& message);
void lengthOfOtherTool(const LintView& view, const FindingRow& message);
void diameterMissing(const LintView& view, const FindingRow& message);
void compensationOnArc(const LintView& view, const FindingRow& message);
void unitsMixed(const LintView& view, const FindingRow& message);
void leftOn(const LintView& view, const FindingRow& message);
void changeLow(const LintView& view, const FindingRow& message);
void changeTurning(const LintView& view, const FindingRow& message);
void noPoint(const LintView& view, const FindingRow& message);
void nearlyHalfCircle(const LintView& view, const FindingRow& message);

} // namespace proveout::lint
