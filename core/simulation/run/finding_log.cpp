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
#include "core/base/list_argument.h"
#include "core/base/text.h"
#include "core/cutter/shapes.h"

namespace proveout {

namespace {

/// A message without its value and place.
struct FindingRow {
    Severity severity;
    bool unverified;
    const char* id;
    const char* text;
    const char* hint;
};

/// One row a kind of finding, in the order of FindingKind.
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
    FindingRow{Severity::error, true, "rapid-unchecked",
               PROVEOUT_TEXT("Core",
                             "The rapid motion passes over the stock at a height that is not known; whether "
                             "it cuts is not known."),
               PROVEOUT_TEXT("Core", "Position Z above the stock before the rapid.")},
    FindingRow{Severity::fault, false, "neck-in-stock",
               PROVEOUT_TEXT("Core", "The neck of the cutter goes through {} mm of stock above its head."),
               PROVEOUT_TEXT("Core", "Cut a slot for the neck first, or choose a tool with a thinner neck.")},
    FindingRow{Severity::error, true, "overhang-lost",
               PROVEOUT_TEXT("Core",
                             "Above the head of the cutter {} mm³ of stock stay, which the z-map shows as "
                             "removed; the layer is highest at X{} Y{} Z{}."),
               PROVEOUT_TEXT("Core", "Check by other means what is done there from here on.")},
};

constexpr const char* kConfirmTool =
    PROVEOUT_TEXT("Core", "Confirm the sizes of the tool in the tool table, or correct them.");

/// What a fault is that was found with a tool whose sizes are not confirmed: as the row of its kind, and the
/// tool is named behind the value. Kinds that are no faults anyway have none.
constexpr std::array<std::pair<FindingKind, FindingRow>, 3> kUnconfirmedRows{{
    {FindingKind::rapidCuts,
     {Severity::warning, true, "rapid-cuts",
      PROVEOUT_TEXT("Core", "Rapid move cuts stock ({} mm deep) with the unconfirmed tool T{}."),
      kConfirmTool}},
    {FindingKind::depthBeyondFlutes,
     {Severity::warning, true, "depth-beyond-flutes",
      PROVEOUT_TEXT("Core", "The cut is {} mm deep, beyond the flutes of the unconfirmed tool T{}."),
      kConfirmTool}},
    {FindingKind::neckInStock,
     {Severity::warning, true, "neck-in-stock",
      PROVEOUT_TEXT("Core", "{} mm of stock meet the neck of the unconfirmed tool T{}."), kConfirmTool}},
}};

const FindingRow& rowOf(FindingKind kind, bool unconfirmed) {
    const auto* const row =
        std::ranges::find(kUnconfirmedRows, kind, [](const auto& entry) { return entry.first; });
    return unconfirmed && row != kUnconfirmedRows.end() ? row->second : kRows[static_cast<std::size_t>(kind)];
}

// About the tools.
constexpr FindingRow kToolFromComment{
    Severity::warning, true, "tool-unconfirmed",
    PROVEOUT_TEXT("Core", "T{} is read from a comment (⌀ {} mm {}); it is not confirmed."), kConfirmTool};
constexpr FindingRow kToolFromVagueComment{
    Severity::warning, true, "tool-unconfirmed",
    PROVEOUT_TEXT("Core", "T{} is read from a comment (⌀ {} mm {}; assumed: {}); it is not "
                          "confirmed."),
    kConfirmTool};
constexpr FindingRow kToolSizesAssumed{
    Severity::warning, true, "tool-unconfirmed",
    PROVEOUT_TEXT("Core", "The sizes of T{} are assumed (⌀ {} mm {}); they are not confirmed."),
    kConfirmTool};
constexpr const char* kSetToolAtStart =
    PROVEOUT_TEXT("Core", "Set the tool at start in the setup if this is the right one.");
constexpr FindingRow kToolAssumed{
    Severity::warning, true, "tool-assumed",
    PROVEOUT_TEXT("Core", "The program cuts before it calls a tool; T{} is assumed to be in the spindle."),
    kSetToolAtStart};
constexpr FindingRow kOnlyToolAssumed{
    Severity::warning, true, "tool-assumed",
    PROVEOUT_TEXT("Core", "The program calls no tool; T{} is assumed to be in the spindle."),
    kSetToolAtStart};
constexpr FindingRow kToolUndefined{
    Severity::error, true, "tool-undefined",
    PROVEOUT_TEXT("Core", "T{} is not in the tool table; its moves are not simulated."),
    PROVEOUT_TEXT("Core", "Define it in the tool table.")};
constexpr FindingRow kNoTool{
    Severity::error, true, "no-tool",
    PROVEOUT_TEXT("Core", "The program cuts before it calls a tool; moves are not simulated until it does."),
    PROVEOUT_TEXT("Core", "Set the tool at start in the setup, or program T and M6 before the first cut.")};
constexpr FindingRow kNoToolEver{
    Severity::error, true, "no-tool",
    PROVEOUT_TEXT("Core", "The program calls no tool; its moves are not simulated."),
    PROVEOUT_TEXT("Core", "Set the tool at start in the setup, or program T and M6 before the first cut.")};
constexpr FindingRow kSpindleEmpty{
    Severity::error, true, "no-tool",
    PROVEOUT_TEXT("Core", "T{} leaves the spindle empty; its moves are not simulated."),
    PROVEOUT_TEXT("Core", "Define T0 in the tool table if it is a cutter.")};

const FindingRow& rowOf(const MissingTool& missing, bool callsTool) {
    if (missing.number != 0)
        return kToolUndefined;
    if (missing.called)
        return kSpindleEmpty;
    return callsTool ? kNoTool : kNoToolEver;
}

void tell(BoundedDiagnostics& out, const FindingRow& row, std::vector<std::string> values,
          std::uint32_t line) {
    out.add({row.severity,
             row.unverified,
             row.id,
             row.text,
             std::move(values),
             row.hint,
             {},
             {static_cast<int>(line), 1, 0}});
}

std::string diameterOf(const std::string& spec) {
    const Result<Cutter> cutter = parseCutter(spec);
    return cutter ? fmt::format("{:.6g}", 2 * cutter->radius()) : std::string();
}

std::string assumedOf(const UnconfirmedTool& tool) {
    std::vector<std::string> labels;
    for (const std::string& key : tool.origin.defaults)
        if (const char* label = labelOfDefault(tool.cutter, key))
            labels.emplace_back(label);
    return listArgument(labels);
}

void tellUnconfirmed(BoundedDiagnostics& out, const UnconfirmedTool& tool) {
    const CutterShape* shape = shapeOf(tool.cutter);
    std::vector<std::string> values{std::to_string(tool.number), diameterOf(tool.cutter),
                                    shape == nullptr ? "" : shape->label};
    if (tool.origin.source == ToolSource::assumed)
        return tell(out, kToolSizesAssumed, std::move(values), tool.line);
    std::string assumed = assumedOf(tool);
    if (assumed.empty())
        return tell(out, kToolFromComment, std::move(values), tool.origin.line);
    values.push_back(std::move(assumed));
    tell(out, kToolFromVagueComment, std::move(values), tool.origin.line);
}

void tellAboutTools(const Program& program, const ToolChoice& tools, BoundedDiagnostics& out) {
    if (tools.assumed() && program.blockCount() > 0)
        tell(out, tools.callsTool() ? kToolAssumed : kOnlyToolAssumed, {std::to_string(*tools.assumed())},
             program.blockLine(0));
    for (const MissingTool& missing : tools.missing())
        tell(out, rowOf(missing, tools.callsTool()), {std::to_string(missing.number)}, missing.line);
    for (const UnconfirmedTool& tool : tools.unconfirmed())
        tellUnconfirmed(out, tool);
}

} // namespace

void FindingLog::add(std::size_t block, FindingKind kind, double value, bool unconfirmed) {
    const auto index = static_cast<std::uint32_t>(block);
    for (auto finding = m_findings.rbegin(); finding != m_findings.rend() && finding->block == index;
         ++finding)
        if (finding->kind == kind) {
            finding->value = std::max(finding->value, value);
            --countOf(*finding);
            finding->unconfirmed = finding->unconfirmed && unconfirmed;
            ++countOf(*finding);
            return;
        }
    ++countOf(m_findings.emplace_back(Finding{index, kind, unconfirmed, value}));
}

void FindingLog::add(std::size_t block, FindingKind kind, double value, bool unconfirmed, const Vec3& place) {
    add(block, kind, value, unconfirmed);
    m_places.insert_or_assign(static_cast<std::uint32_t>(block), place);
}

std::vector<std::string> FindingLog::argumentsOf(const Finding& finding, const Program& program,
                                                 const ToolChoice& tools) const {
    std::vector<std::string> arguments = {fmt::format("{:.3f}", finding.value)};
    const auto place = m_places.find(finding.block);
    if (finding.kind == FindingKind::overhangLost && place != m_places.end()) {
        for (int axis = 0; axis < 3; ++axis)
            arguments.push_back(fmt::format("{:.3f}", place->second[axis]));
    } else if (finding.unconfirmed) {
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
    m_places.erase(m_places.lower_bound(static_cast<std::uint32_t>(block)), m_places.end());
    const auto first = std::ranges::lower_bound(m_findings, block, {}, &Finding::block);
    for (auto gone = first; gone != m_findings.end(); ++gone)
        --countOf(*gone);
    m_findings.erase(first, m_findings.end());
}

Diagnostics FindingLog::diagnostics(const Program& program, const ToolChoice& tools) const {
    BoundedDiagnostics out;
    tellAboutTools(program, tools, out);
    std::set<std::tuple<std::uint32_t, FindingKind, bool>> told;
    static_assert(kRows.size() == kKinds);
    auto left = m_counts;
    for (const Finding& finding : m_findings) {
        if (out.full())
            break;
        --left[finding.unconfirmed ? 1 : 0][static_cast<std::size_t>(finding.kind)];
        const auto line = program.blockLine(finding.block);
        if (told.emplace(line, finding.kind, finding.unconfirmed).second)
            tell(out, rowOf(finding.kind, finding.unconfirmed), argumentsOf(finding, program, tools), line);
    }
    for (const bool unconfirmed : {false, true})
        for (std::size_t kind = 0; kind < kKinds; ++kind) {
            const FindingRow& row = rowOf(static_cast<FindingKind>(kind), unconfirmed);
            out.leaveOut(row.severity, row.unverified, left[unconfirmed ? 1 : 0][kind]);
        }
    return out.take("more-findings",
                    PROVEOUT_TEXT("Core", "{} more findings of the simulation are not shown."));
}

} // namespace proveout
