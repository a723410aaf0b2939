// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/finding_log.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <set>
#include <utility>

#include "core/base/text.h"

namespace proveout {

namespace {

/// One row a kind of finding, in the order of FindingKind.
struct FindingRow {
    Severity severity;
    bool unverified;
    const char* id;
    const char* text;
    const char* hint;
};
constexpr std::array kRows{
    FindingRow{Severity::fault, false, "rapid-cuts",
               PROVEOUT_TEXT("Core", "The rapid motion removes material, {} mm deep."),
               PROVEOUT_TEXT("Core", "Retract above the stock before the rapid, or cut with G1.")},
    FindingRow{Severity::fault, false, "depth-beyond-flutes",
               PROVEOUT_TEXT("Core", "The cut is {} mm deep, beyond the length of the flutes."),
               PROVEOUT_TEXT("Core", "Cut in shallower passes, or choose a tool with longer flutes.")},
    FindingRow{Severity::error, true, "rapid-unchecked",
               PROVEOUT_TEXT("Core",
                             "The rapid motion comes from an unknown position and ends {} mm below the "
                             "top of the stock; what it cuts is not known."),
               PROVEOUT_TEXT("Core", "Retract above the stock before the rapid, or cut with G1.")},
    FindingRow{Severity::error, true, "tool-undefined",
               PROVEOUT_TEXT("Core", "No cutter is defined for tool T{}; its motions cut nothing."),
               PROVEOUT_TEXT("Core", "Add the tool to the tool table.")},
    FindingRow{Severity::error, true, "no-tool",
               PROVEOUT_TEXT("Core", "The program cuts with no tool in the spindle."),
               PROVEOUT_TEXT("Core", "Select a tool with T and M6 before the first cut.")},
};

const FindingRow& row(FindingKind kind) {
    return kRows[static_cast<std::size_t>(kind)];
}

std::string shown(FindingKind kind, double value) {
    return kind == FindingKind::toolUndefined ? fmt::format("{:.0f}", value) : fmt::format("{:.3f}", value);
}

Diagnostic sentence(FindingKind kind, double value, std::uint32_t line) {
    Diagnostic diagnostic;
    diagnostic.severity = row(kind).severity;
    diagnostic.unverified = row(kind).unverified;
    diagnostic.id = row(kind).id;
    diagnostic.text = row(kind).text;
    diagnostic.arguments = {shown(kind, value)};
    diagnostic.hint = row(kind).hint;
    diagnostic.where = {static_cast<int>(line), 1, 0};
    return diagnostic;
}

Diagnostic assumption(int tool, std::uint32_t line) {
    Diagnostic diagnostic;
    diagnostic.severity = Severity::note;
    diagnostic.id = "tool-assumed";
    diagnostic.text = PROVEOUT_TEXT("Core", "The program never selects a tool; tool T{} is used.");
    diagnostic.arguments = {std::to_string(tool)};
    diagnostic.where = {static_cast<int>(line), 1, 0};
    return diagnostic;
}

} // namespace

void FindingLog::add(std::size_t block, FindingKind kind, double value) {
    const bool missing = kind == FindingKind::toolUndefined || kind == FindingKind::noTool;
    if (missing && !m_missing.emplace(static_cast<int>(value), block).second)
        return;
    const auto index = static_cast<std::uint32_t>(block);
    for (auto finding = m_findings.rbegin(); finding != m_findings.rend() && finding->block == index;
         ++finding)
        if (finding->kind == kind) {
            finding->value = std::max(finding->value, value);
            return;
        }
    m_findings.push_back({index, kind, value});
}

void FindingLog::truncate(std::size_t block) {
    const auto first = std::ranges::lower_bound(m_findings, block, {}, &Finding::block);
    m_findings.erase(first, m_findings.end());
    std::erase_if(m_missing, [block](const auto& missing) { return missing.second >= block; });
}

Diagnostics FindingLog::diagnostics(const Program& program, const ToolChoice& tools) const {
    Diagnostics out;
    if (tools.assumed() && program.blockCount() > 0)
        out.push_back(assumption(*tools.assumed(), program.blockLine(0)));

    std::set<std::pair<std::uint32_t, FindingKind>> told;
    auto finding = m_findings.begin();
    for (; finding != m_findings.end() && out.size() < kMaxFindings; ++finding) {
        const auto line = program.blockLine(finding->block);
        if (told.emplace(line, finding->kind).second)
            out.push_back(sentence(finding->kind, finding->value, line));
    }
    Diagnostic more;
    more.severity = Severity::note;
    const auto left = std::distance(finding, m_findings.end());
    for (; finding != m_findings.end(); ++finding) {
        more.severity = std::max(more.severity, row(finding->kind).severity);
        more.unverified = more.unverified || row(finding->kind).unverified;
    }
    if (left > 0) {
        more.id = "more-findings";
        more.text = PROVEOUT_TEXT("Core", "{} more findings of the simulation are not shown.");
        more.arguments = {std::to_string(left)};
        out.push_back(std::move(more));
    }
    return out;
}

} // namespace proveout
