// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/run/finding_log.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "core/base/bounded_diagnostics.h"
#include "core/base/figures_argument.h"
#include "core/base/list_argument.h"
#include "core/cutter/shapes.h"
#include "core/simulation/run/cutting_findings.h"
#include "core/simulation/run/tool_findings.h"

namespace proveout {

namespace {

/// The row of a kind of finding, and the row used instead while the sizes of the tool are not confirmed: its
/// sentence also has the tool number. Null for kinds that are not faults.
struct KindRows {
    const FindingRow* confirmed;
    const FindingRow* unconfirmed;
    const char* unit = "mm"; ///< of its value
    bool saysPlace = false;  ///< X, Y and Z are in its sentence
};

/// In the order of FindingKind.
constexpr std::array kKindRows{
    KindRows{&cutting_finding::kRapidCuts, &cutting_finding::kRapidCutsUnconfirmed},
    KindRows{&cutting_finding::kDepthBeyondFlutes, &cutting_finding::kDepthBeyondFlutesUnconfirmed},
    KindRows{&cutting_finding::kRapidUncheckedStart, nullptr},
    KindRows{&cutting_finding::kRapidUncheckedHeight, nullptr, ""},
    KindRows{&cutting_finding::kNeckInStock, &cutting_finding::kNeckInStockUnconfirmed},
    KindRows{&cutting_finding::kOverhangLost, nullptr, "mm³", true},
    KindRows{&cutting_finding::kHolderCollision, &cutting_finding::kHolderCollisionUnconfirmed, "mm", true},
    KindRows{&cutting_finding::kShankCollision, &cutting_finding::kShankCollisionUnconfirmed, "mm", true},
    KindRows{&cutting_finding::kCorePlunges, &cutting_finding::kCorePlungesUnconfirmed},
};

const FindingRow& rowOf(FindingKind kind, bool unconfirmed) {
    const KindRows& rows = kKindRows[static_cast<std::size_t>(kind)];
    return unconfirmed && rows.unconfirmed != nullptr ? *rows.unconfirmed : *rows.confirmed;
}

const FindingRow& rowOf(const MissingTool& missing, bool callsTool) {
    if (missing.number != 0)
        return tool_finding::kToolUndefined;
    if (missing.called)
        return tool_finding::kNoToolCalled;
    return callsTool ? tool_finding::kNoTool : tool_finding::kNoToolEver;
}

void report(BoundedDiagnostics& out, const FindingRow& row, std::vector<Argument> values,
            std::uint32_t line) {
    Diagnostic finding = diagnosticOf(row, std::move(values));
    finding.where = {static_cast<int>(line), 1, 0};
    out.add(std::move(finding));
}

Argument diameterOf(const std::string& spec) {
    const Result<Cutter> cutter = parseCutter(spec);
    return cutter ? figures("{:.6g}", 2 * cutter->radius()) : Argument("");
}

std::string assumedOf(const UnconfirmedTool& tool) {
    std::vector<std::string> labels;
    for (const std::string& key : tool.origin.defaults)
        if (const char* label = labelOfDefault(tool.cutter, key))
            labels.emplace_back(label);
    return listArgument(labels);
}

void reportUnconfirmed(BoundedDiagnostics& out, const UnconfirmedTool& tool) {
    const CutterShape* shape = shapeOf(tool.cutter);
    std::vector<Argument> values{std::to_string(tool.number), diameterOf(tool.cutter),
                                 shape == nullptr ? "" : shape->label};
    if (tool.origin.source == ToolSource::assumed)
        return report(out, tool_finding::kToolUnconfirmedSizes, std::move(values), tool.line);
    std::string assumed = assumedOf(tool);
    if (assumed.empty())
        return report(out, tool_finding::kToolUnconfirmedComment, std::move(values), tool.origin.line);
    values.push_back(std::move(assumed));
    report(out, tool_finding::kToolUnconfirmedVague, std::move(values), tool.origin.line);
}

void reportAboutTools(const Program& program, const ToolChoice& tools, BoundedDiagnostics& out) {
    if (tools.assumed() && program.blockCount() > 0)
        report(out, tools.callsTool() ? tool_finding::kToolAssumed : tool_finding::kToolAssumedOnly,
               {std::to_string(*tools.assumed())}, program.blockLine(0));
    for (const MissingTool& missing : tools.missing())
        report(out, rowOf(missing, tools.callsTool()), {std::to_string(missing.number)}, missing.line);
    for (const UnconfirmedTool& tool : tools.unconfirmed())
        reportUnconfirmed(out, tool);
}

} // namespace

bool FindingLog::keepLarger(std::uint32_t block, FindingKind kind, double value, bool unconfirmed) {
    for (auto finding = m_findings.rbegin(); finding != m_findings.rend() && finding->block == block;
         ++finding)
        if (finding->kind == kind) {
            const bool isLarger = value > finding->value;
            finding->value = std::max(finding->value, value);
            --countOf(*finding);
            finding->unconfirmed = finding->unconfirmed && unconfirmed;
            ++countOf(*finding);
            return isLarger;
        }
    ++countOf(m_findings.emplace_back(Finding{block, kind, unconfirmed, value}));
    return true;
}

void FindingLog::add(std::size_t block, FindingKind kind, double value, bool unconfirmed) {
    (void)keepLarger(static_cast<std::uint32_t>(block), kind, value, unconfirmed);
}

void FindingLog::add(std::size_t block, FindingKind kind, double value, bool unconfirmed, const Vec3& place) {
    const auto index = static_cast<std::uint32_t>(block);
    if (!keepLarger(index, kind, value, unconfirmed))
        return;
    if (const std::size_t known = placeOf(index, kind); known < m_places.size())
        m_places[known].at = place;
    else
        m_places.push_back({index, kind, place});
}

std::size_t FindingLog::placeOf(std::uint32_t block, FindingKind kind) const {
    const auto first = std::ranges::lower_bound(m_places, block, {}, &Place::block);
    const auto found = std::find_if(first, m_places.end(), [&](const Place& place) {
        return place.block != block || place.kind == kind;
    });
    const bool exists = found != m_places.end() && found->block == block;
    return exists ? static_cast<std::size_t>(found - m_places.begin()) : m_places.size();
}

std::vector<Argument> FindingLog::argumentsOf(const Finding& finding, const Program& program,
                                              const ToolChoice& tools) const {
    std::vector<Argument> arguments = {figures("{:.3f}", finding.value)};
    const std::size_t place = placeOf(finding.block, finding.kind);
    if (kKindRows[static_cast<std::size_t>(finding.kind)].saysPlace && place < m_places.size())
        for (int axis = 0; axis < 3; ++axis)
            arguments.push_back(figures("{:.3f}", m_places[place].at[axis]));
    if (finding.unconfirmed && kKindRows[static_cast<std::size_t>(finding.kind)].unconfirmed != nullptr) {
        const std::size_t last = program.blockMotions(finding.block).last - 1;
        arguments.push_back(std::to_string(tools.tool(program.motion(last).tool)));
    }
    return arguments;
}

bool FindingLog::foundAt(std::size_t block) const {
    const auto found = std::ranges::lower_bound(m_findings, block, {}, &Finding::block);
    return found != m_findings.end() && found->block == block;
}

void FindingLog::truncate(std::size_t block) {
    m_places.erase(std::ranges::lower_bound(m_places, block, {}, &Place::block), m_places.end());
    const auto first = std::ranges::lower_bound(m_findings, block, {}, &Finding::block);
    for (auto gone = first; gone != m_findings.end(); ++gone)
        --countOf(*gone);
    m_findings.erase(first, m_findings.end());
}

Diagnostics FindingLog::diagnostics(const Program& program, const ToolChoice& tools) const {
    BoundedDiagnostics out;
    reportAboutTools(program, tools, out);
    std::set<std::tuple<std::uint32_t, FindingKind, bool>> reported;
    static_assert(kKindRows.size() == kKinds);
    auto left = m_counts;
    for (const Finding& finding : m_findings) {
        if (out.full())
            break;
        --left[finding.unconfirmed ? 1 : 0][static_cast<std::size_t>(finding.kind)];
        const auto line = program.blockLine(finding.block);
        if (reported.emplace(line, finding.kind, finding.unconfirmed).second)
            report(out, rowOf(finding.kind, finding.unconfirmed), argumentsOf(finding, program, tools), line);
    }
    for (const bool unconfirmed : {false, true})
        for (std::size_t kind = 0; kind < kKinds; ++kind) {
            const FindingRow& row = rowOf(static_cast<FindingKind>(kind), unconfirmed);
            out.omit(row.severity, row.unverified, left[unconfirmed ? 1 : 0][kind]);
        }
    return out.take(cutting_finding::kMoreFindings);
}

std::vector<FindingGroup> FindingLog::groups(const Program& program, const ToolChoice& tools) const {
    struct Kept {
        FindingGroup group;
        const Finding* worst;
    };
    std::vector<Kept> kept;
    for (const Finding& finding : m_findings) {
        const std::size_t last = program.blockMotions(finding.block).last - 1;
        const int tool = tools.tool(program.motion(last).tool);
        const auto same = [&](const Kept& one) {
            return one.group.tool == tool && one.worst->kind == finding.kind &&
                   one.worst->unconfirmed == finding.unconfirmed;
        };
        auto found = std::ranges::find_if(kept, same);
        if (found == kept.end())
            found = kept.insert(found, {{.firstBlock = finding.block, .tool = tool}, &finding});
        found->group.lastBlock = finding.block;
        ++found->group.count;
        if (finding.value > found->worst->value)
            found->worst = &finding;
    }
    std::vector<FindingGroup> groups;
    for (Kept& one : kept) {
        one.group.worst = diagnosticOf(rowOf(one.worst->kind, one.worst->unconfirmed),
                                       argumentsOf(*one.worst, program, tools));
        one.group.worst.where = {static_cast<int>(program.blockLine(one.group.firstBlock)), 1, 0};
        one.group.worstBlock = one.worst->block;
        one.group.value = one.worst->value;
        if (const std::size_t place = placeOf(one.worst->block, one.worst->kind); place < m_places.size())
            one.group.place = m_places[place].at;
        one.group.unit = kKindRows[static_cast<std::size_t>(one.worst->kind)].unit;
        groups.push_back(std::move(one.group));
    }
    return groups;
}

} // namespace proveout
