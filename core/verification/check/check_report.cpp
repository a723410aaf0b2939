// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verification/check/check_report.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <string>
#include <tuple>

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

CheckChange changeBetween(const CheckReport& before, const CheckReport& after) {
    using Key = std::tuple<std::string, int, std::string>;
    std::map<Key, std::ptrdiff_t> more;
    const auto count = [&](const CheckReport& report, std::ptrdiff_t by) {
        for (const CheckFinding& one : report.findings)
            more[{one.diagnostic.id, one.tool, message(one.diagnostic)}] += by;
    };
    count(after, 1);
    count(before, -1);
    CheckChange change;
    for (const auto& [key, by] : more)
        (by > 0 ? change.added : change.gone) += static_cast<std::size_t>(std::abs(by));
    return change;
}

} // namespace proveout
