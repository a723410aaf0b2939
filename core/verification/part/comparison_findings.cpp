// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verification/part/comparison_findings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "core/base/figures_argument.h"
#include "core/part/part_findings.h"

namespace proveout {

namespace {

constexpr double kLeastOverlap = 0.5;
constexpr double kPercent = 100;
constexpr double kMicrons = 1000; // in a millimetre: no figure is as exact

/// The islands of one kind and one tool.
class Group {
public:
    Group(const FindingRow& row, double limit) : m_finding{.row = &row, .limit = limit} {}

    void add(const ComparedIsland& island) {
        if (island.block) {
            m_blocks.insert(*island.block);
            m_finding.tool = island.tool;
        }
        if (island.of.depthMm <= m_finding.value)
            return;
        m_finding.value = island.of.depthMm;
        m_finding.place = island.of.place;
        if (island.block)
            m_finding.worstBlock = *island.block;
    }

    [[nodiscard]] RuleFinding take() {
        if (!m_blocks.empty()) {
            m_finding.block = *m_blocks.begin();
            m_finding.lastBlock = *m_blocks.rbegin();
            m_finding.count = m_blocks.size();
        }
        m_finding.value = std::round(m_finding.value * kMicrons) / kMicrons;
        return std::move(m_finding);
    }

private:
    RuleFinding m_finding;
    std::set<std::size_t> m_blocks;
};

const FindingRow& rowOf(const ComparedIsland& island) {
    if (island.of.kind == IslandKind::excess)
        return part_finding::kExcess;
    return island.isUncut ? part_finding::kNeverThere : part_finding::kGouge;
}

} // namespace

std::vector<RuleFinding> findingsOf(const PartComparison& comparison) {
    std::vector<std::pair<std::pair<const FindingRow*, int>, Group>> groups;
    for (const ComparedIsland& island : comparison.islands) {
        const FindingRow& row = rowOf(island);
        const std::pair key(&row, island.block ? island.tool : -1);
        auto at = std::ranges::find(groups, key, [](const auto& group) { return group.first; });
        if (at == groups.end()) {
            const bool isExcess = island.of.kind == IslandKind::excess;
            const double limit = isExcess ? comparison.tolerance.above : comparison.tolerance.below;
            groups.emplace_back(key, Group(row, limit));
            at = groups.end() - 1;
        }
        at->second.add(island);
    }
    std::vector<RuleFinding> findings;
    findings.reserve(groups.size());
    for (auto& group : groups)
        findings.push_back(group.second.take());
    const DeviationLimits& limits = comparison.deviation.limits();
    const auto addIf = [&](const FindingRow& row, double value) {
        if (value > 0)
            findings.push_back({.row = &row, .value = value});
    };
    addIf(part_finding::kSideUnknown, static_cast<double>(limits.pointsWithoutSide));
    addIf(part_finding::kRibsUnseen, static_cast<double>(unseenRibs(comparison.deviation.stock().rims())));
    addIf(part_finding::kUnresolved, std::round(limits.unresolvedMm2 * kMicrons) / kMicrons);
    addIf(part_finding::kUndercut, std::round(limits.hiddenMm2 * kMicrons) / kMicrons);
    return findings;
}

const char* comparisonUnit(const FindingRow& row) {
    if (&row == &part_finding::kUnresolved || &row == &part_finding::kUndercut)
        return "mm²";
    return &row == &part_finding::kSideUnknown || &row == &part_finding::kRibsUnseen ? "" : "mm";
}

bool isMisplaced(const DesignPart& part, const StockBox& stock) {
    return overlap(part, stock) < kLeastOverlap;
}

Diagnostics placementFindings(const DesignPart& part, const StockBox& stock, const PartTolerance& tolerance) {
    if (isMisplaced(part, stock))
        return {diagnosticOf(part_finding::kMisplaced, {figures("{:.0f}", kPercent * overlap(part, stock))})};
    const Box3& box = part.box();
    const std::array<std::pair<double, const char*>, 6> sides{
        {{box.hi.z - stock.topZ(), "+Z"},
         {stock.floorZ() - box.lo.z, "−Z"},
         {stock.corner.x - box.lo.x, "−X"},
         {box.hi.x - stock.corner.x - stock.width, "+X"},
         {stock.corner.y - box.lo.y, "−Y"},
         {box.hi.y - stock.corner.y - stock.depth, "+Y"}}};
    const auto [beyond, side] = *std::ranges::max_element(sides);
    if (beyond <= tolerance.below)
        return {};
    return {diagnosticOf(part_finding::kOutsideStock, {figures("{:.3f}", beyond), side})};
}

} // namespace proveout
