// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verification/rules/rules.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "core/base/figures_argument.h"
#include "core/verification/findings/rule_findings.h"
#include "core/verification/rules/first_contacts.h"

namespace proveout {

namespace {

using namespace rule_finding;

constexpr std::array<const FindingRow*, 1> kOfStoppedSpindle{&kSpindleStopped};
constexpr std::array<const FindingRow*, 1> kOfUnusedSpindle{&kSpindleNeverTurns};
constexpr std::array<const FindingRow*, 1> kOfReversedSpindle{&kSpindleReversed};
constexpr std::array<const FindingRow*, 1> kOfFeed{&kFeedLimit};
constexpr std::array<const FindingRow*, 2> kOfDrill{&kDrillSideways, &kDrillSidewaysUnconfirmed};
constexpr std::array<const FindingRow*, 2> kOfRemoval{&kNothingCut, &kHardlyCuts};
constexpr std::array<const FindingRow*, 2> kOfUnits{&kUnitsTooLarge, &kUnitsTooSmall};
constexpr std::array<const FindingRow*, 1> kOfRoom{&kTableCollision};
constexpr std::array<const FindingRow*, 1> kOfFixtures{&kFixtureCollision};
constexpr std::array<const FindingRow*, 1> kOfFixtureClearance{&kFixtureNear};
constexpr std::array<const FindingRow*, 1> kOfPieces{&kLoosePiece};
constexpr std::array<const FindingRow*, 1> kOfAir{&kAirCutting};
constexpr std::array<const FindingRow*, 1> kOfClearance{&kRapidTooClose};
constexpr std::array<const FindingRow*, 1> kOfDepth{&kDepthLimit};
constexpr std::array<const FindingRow*, 1> kOfEngagement{&kEngagementLimit};
constexpr std::array<const FindingRow*, 1> kOfJumps{&kEngagementJump};
constexpr std::array<const FindingRow*, 1> kOfSlots{&kFullSlot};
constexpr std::array<const FindingRow*, 1> kOfChips{&kChipLimit};
constexpr std::array<const FindingRow*, 1> kOfSurface{&kSurfaceSpeed};
constexpr std::array<const FindingRow*, 1> kOfRate{&kRemovalRate};
constexpr std::array<const FindingRow*, 1> kOfToolFeed{&kToolFeedLimit};
constexpr std::array<const FindingRow*, 1> kOfToolSpindle{&kToolSpindleLimit};
constexpr std::array<const FindingRow*, 1> kOfSpindle{&kSpindleLimit};
constexpr std::array<const FindingRow*, 1> kOfRamps{&kRampTooSteep};
constexpr std::array<const FindingRow*, 1> kOfTapFeed{&kTapFeed};
constexpr std::array<const FindingRow*, 1> kOfTapOut{&kTapNotReversed};
constexpr std::array<const FindingRow*, 1> kOfTravel{&kTravelLimit};
constexpr std::array<const FindingRow*, 1> kOfToolChange{&kToolChangePosition};
constexpr std::array<const FindingRow*, 1> kOfHolderNear{&kHolderNear};
constexpr std::array<const FindingRow*, 1> kOfShankNear{&kShankNear};

constexpr std::array kRules{
    Rule{kOfStoppedSpindle, "mm", judgeStoppedSpindle, needForStoppedSpindle},
    Rule{kOfUnusedSpindle, "mm", judgeUnusedSpindle, needForStoppedSpindle},
    Rule{kOfReversedSpindle, "mm", judgeReversedSpindle, needForReversedSpindle},
    Rule{kOfFeed, "mm/min", judgeFeedLimit},
    Rule{kOfDrill, "mm", judgeSidewaysDrill, needForSidewaysDrill},
    Rule{kOfRemoval, "%", judgeRemoval, needForRemoval},
    Rule{kOfUnits, "", judgeUnits},
    Rule{kOfRoom, "mm", judgeRoomBelow, nullptr, "belowStock"},
    Rule{kOfFixtures, "mm", judgeFixtures},
    Rule{kOfFixtureClearance, "mm", judgeFixtureClearance, nullptr, "fixtureClearance"},
    Rule{kOfPieces, "mm³", judgeLoosePieces},
    Rule{kOfAir, "s", judgeAirCutting, needForAirCutting, "airSeconds"},
    Rule{kOfClearance, "mm", judgeClearance, nullptr, "rapidClearance"},
    Rule{kOfDepth, "mm", judgeDepth, needForDepth},
    Rule{kOfEngagement, "mm", judgeEngagement, needForEngagement},
    Rule{kOfJumps, "mm", judgeEngagementJumps, needForEngagement},
    Rule{kOfSlots, "mm", judgeFullSlots, needForFullSlots},
    Rule{kOfChips, "mm", judgeChips, needForChips},
    Rule{kOfSurface, "m/min", judgeSurfaceSpeed, needForSurfaceSpeed},
    Rule{kOfRate, "cm³/min", judgeRemovalRate, needForRemovalRate},
    Rule{kOfToolFeed, "mm/min", judgeToolFeed, needForToolFeed},
    Rule{kOfToolSpindle, "rpm", judgeToolSpindle, needForToolSpindle},
    Rule{kOfSpindle, "rpm", judgeSpindleLimit},
    Rule{kOfRamps, "°", judgeRamps, needForRamps},
    Rule{kOfTapFeed, "mm/min", judgeTapFeed, needForTaps, "tapFeedError"},
    Rule{kOfTapOut, "mm", judgeTapOut, needForTaps},
    Rule{kOfTravel, "mm", judgeTravel},
    Rule{kOfToolChange, "mm", judgeToolChanges},
    Rule{kOfHolderNear, "mm", judgeHolderClearance, nullptr, "holderClearance"},
    Rule{kOfShankNear, "mm", judgeShankClearance, nullptr, "holderClearance"},
};

} // namespace

RuleFinding& RuleFindings::merged(const FindingRow& row, std::size_t block, int tool, double value,
                                  double limit, const std::string& what, std::optional<Vec3> place) {
    const auto same = [&](const RuleFinding& one) {
        return one.row == &row && one.block && one.tool == tool && one.what == what;
    };
    const auto found = std::ranges::find_if(m_all, same);
    if (found == m_all.end())
        return m_all.emplace_back(RuleFinding{&row, block, block, block, 1, tool, value, limit, place, what});
    found->count += found->lastBlock == block ? 0 : 1;
    found->lastBlock = block;
    if (value > found->value) {
        found->value = value;
        found->worstBlock = block;
        found->place = place;
    }
    return *found;
}

void RuleFindings::add(const FindingRow& row, std::size_t block, int tool, double value, double limit,
                       const std::string& what, std::optional<Vec3> place) {
    (void)merged(row, block, tool, value, limit, what, place);
}

void RuleFindings::addAtLine(std::uint32_t line, const FindingRow& row, std::size_t block, int tool,
                             double value, double limit, const std::string& what, std::optional<Vec3> place) {
    RuleFinding& finding = merged(row, block, tool, value, limit, what, place);
    finding.line = finding.line == 0 ? line : finding.line;
    finding.lastLine = line;
}

void RuleFindings::add(const FindingRow& row, double value, double limit, std::optional<Vec3> place) {
    m_all.push_back({&row, {}, 0, 0, 1, 0, value, limit, place, {}});
}

std::span<const Rule> rules() {
    return kRules;
}

bool isJudgedBy(const LimitOfTool& limit) {
    return std::ranges::any_of(kRules, [&](const Rule& rule) {
        return rule.limit != nullptr && limit.rule == rule.id() && limit.key == rule.limit;
    });
}

const char* unitOf(const FindingRow& row) {
    for (const Rule& rule : kRules)
        if (std::ranges::find(rule.rows, &row) != rule.rows.end())
            return rule.unit;
    return "";
}

namespace {

/// Findings of blocks with a tool that has limits of its own are by these.
std::vector<RuleFinding> judgedBy(const Rule& rule, const CheckedRun& run, const CheckRules& by) {
    const auto judged = [&](const RuleLimits& limits) {
        RuleFindings findings;
        rule.judge(run, limits, findings);
        return findings.all();
    };
    std::vector<RuleFinding> all = judged(by.limits);
    for (const auto& [tool, limits] : by.limitsOf(rule.id())) {
        const auto isOfTool = [tool = tool](const RuleFinding& one) { return one.block && one.tool == tool; };
        std::erase_if(all, isOfTool);
        std::ranges::copy_if(judged(limits), std::back_inserter(all), isOfTool);
    }
    return all;
}

} // namespace

std::vector<RuleFinding> judge(const CheckedRun& run, const CheckRules& by, const WorkContext& context) {
    std::vector<RuleFinding> all;
    for (const Rule& rule : kRules)
        if (!context.stopped() && !by.off.contains(rule.id()))
            std::ranges::move(judgedBy(rule, run, by), std::back_inserter(all));
    std::erase_if(all, [&by](const RuleFinding& one) { return by.isOff(one.row->id, one.tool); });
    return all;
}

BlockSet neededRecords(const CheckedRun& run, const CheckRules& by, const WorkContext& context) {
    BlockSet needed;
    for (const Rule& rule : kRules) {
        if (context.stopped())
            return needed;
        if (rule.need == nullptr || by.off.contains(rule.id()))
            continue;
        rule.need(run, by.limits, needed);
        for (const auto& ofTool : by.limitsOf(rule.id()))
            rule.need(run, ofTool.second, needed);
    }
    needForFirstContacts(run, needed);
    return needed;
}

Diagnostic diagnosticOf(const RuleFinding& finding, const Program& program) {
    Diagnostic diagnostic = diagnosticOf(
        *finding.row, {figures("{:.6g}", finding.value), figures("{:.6g}", finding.limit), finding.what});
    if (finding.block)
        diagnostic.where = {
            static_cast<int>(finding.line > 0 ? finding.line : program.blockLine(*finding.block)), 1, 0};
    return diagnostic;
}

} // namespace proveout
