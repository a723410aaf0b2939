// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verification/check/check_report.h"

#include <algorithm>

namespace proveout {

Verdict CheckReport::verdict() const {
    Diagnostics diagnostics;
    for (const CheckFinding& finding : findings)
        diagnostics.push_back(finding.diagnostic);
    const Verdict verdict = verdictOf(diagnostics, notChecked);
    return programUnverified && verdict == Verdict::safe ? Verdict::unverified : verdict;
}

std::size_t CheckReport::faults() const {
    return static_cast<std::size_t>(std::ranges::count_if(
        findings, [](const CheckFinding& one) { return one.diagnostic.severity == Severity::fault; }));
}

CheckReport CheckReport::accepting(const std::set<std::string>& accepted) const {
    CheckReport report = *this;
    for (NotChecked& entry : report.notChecked)
        entry.accepted = accepted.contains(entry.row->id);
    return report;
}

} // namespace proveout
