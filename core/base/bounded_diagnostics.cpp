// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/bounded_diagnostics.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/base/base_findings.h"

namespace proveout {

void BoundedDiagnostics::add(Diagnostic diagnostic) {
    if (full())
        omit(diagnostic.severity, diagnostic.unverified, 1);
    else
        m_first.push_back(std::move(diagnostic));
}

void BoundedDiagnostics::omit(Severity severity, bool unverified, std::size_t count) {
    if (count == 0)
        return;
    m_left += count;
    m_worst = std::max(m_worst, severity);
    m_unverified = m_unverified || unverified;
}

void BoundedDiagnostics::sortByPlace() {
    std::ranges::stable_sort(m_first, {}, [](const Diagnostic& diagnostic) {
        return std::pair(diagnostic.where.line, diagnostic.where.column);
    });
}

void BoundedDiagnostics::append(BoundedDiagnostics others) {
    for (Diagnostic& diagnostic : others.m_first)
        add(std::move(diagnostic));
    omit(others.m_worst, others.m_unverified, others.m_left);
}

Diagnostics BoundedDiagnostics::take(const FindingRow& more) {
    BoundedDiagnostics all = std::exchange(*this, {});
    if (all.m_left > 0) {
        Diagnostic last = diagnosticOf(more, {std::to_string(all.m_left)});
        last.severity = all.m_worst;
        last.unverified = all.m_unverified;
        all.m_first.push_back(std::move(last));
    }
    return std::move(all.m_first);
}

Diagnostics BoundedDiagnostics::take() {
    return take(base_finding::kTooManyMessages);
}

} // namespace proveout
