// SPDX-License-Identifier: GPL-3.0-or-later
// The table of rules: what is judged once a program has been run. A new rule is one row, its function, its
// finding and two programs in the tests.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/finding_row.h"
#include "core/base/work_context.h"
#include "core/simulation/run/block_set.h"
#include "core/simulation/setup/check_rules.h"
#include "core/verification/rules/checked_run.h"

namespace proveout {

/// What a rule found: one finding for all blocks of one tool in which it was broken by one thing.
struct RuleFinding {
    const FindingRow* row = nullptr;
    std::optional<std::size_t> block = {}; ///< the first, 0-based; none: the program as a whole
    std::size_t lastBlock = 0;
    std::size_t worstBlock = 0;
    std::size_t count = 1; ///< of blocks
    int tool = 0;          ///< of these blocks
    double value = 0;      ///< the worst
    double limit = 0;
    std::optional<Vec3> place = {}; ///< of the worst
    std::string what =
        {}; ///< the thing, where the rule has several of them; the third argument of the sentence
    std::uint32_t line = 0; ///< of something between blocks, after `block`; 0: the line of the block
    std::uint32_t lastLine = 0;
};

/// Collects what the rules find; owned by one thread.
class RuleFindings {
public:
    /// A block breaks a rule. Blocks must come in order; the larger value is the worse one.
    void add(const FindingRow& row, std::size_t block, int tool, double value, double limit = 0,
             const std::string& what = {}, std::optional<Vec3> place = {});
    /// The same for something in a line after the block that moves nothing.
    void addAtLine(std::uint32_t line, const FindingRow& row, std::size_t block, int tool, double value,
                   double limit, const std::string& what, std::optional<Vec3> place);
    /// Something that concerns no block.
    void add(const FindingRow& row, double value = 0, double limit = 0, std::optional<Vec3> place = {});
    [[nodiscard]] const std::vector<RuleFinding>& all() const { return m_all; }

private:
    RuleFinding& merged(const FindingRow& row, std::size_t block, int tool, double value, double limit,
                        const std::string& what, std::optional<Vec3> place);

    std::vector<RuleFinding> m_all;
};

struct Rule {
    std::span<const FindingRow* const> rows; ///< its findings; all have one id, by which it is turned off
    const char* unit;                        ///< of their values
    void (*judge)(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out);
    /// Adds the blocks whose records it needs and has not; called before the run, and again after it until
    /// there are none. Null: it needs no records.
    void (*need)(const CheckedRun& run, const RuleLimits& limits, BlockSet& out) = nullptr;
    /// The key of the limit (RuleLimits) by which it judges the blocks of a tool; null: there is none.
    const char* limit = nullptr;

    [[nodiscard]] const char* id() const { return rows.front()->id; }
};

[[nodiscard]] std::span<const Rule> rules();
/// Whether a limit of one tool has a rule that judges by it.
[[nodiscard]] bool isJudgedBy(const LimitOfTool& limit);
/// The unit of the values of a finding; empty if it is not of a rule.
[[nodiscard]] const char* unitOf(const FindingRow& row);

/// Judges a run by all rules that are not turned off, in the order of the table; stopped between two rules,
/// by those before it.
[[nodiscard]] std::vector<RuleFinding> judge(const CheckedRun& run, const CheckRules& by,
                                             const WorkContext& context = {});

/// The blocks whose records are missing for judge() and firstContacts(), as far as that is known now: once
/// the run is done, with its records asked for again and again, none is missing in the end.
/// Stopped between two rules: some are not asked for.
[[nodiscard]] BlockSet neededRecords(const CheckedRun& run, const CheckRules& by,
                                     const WorkContext& context = {});

/// The sentence of a finding, at the line of its first block.
[[nodiscard]] Diagnostic diagnosticOf(const RuleFinding& finding, const Program& program);

// The functions of the rows, by subject.

void judgeStoppedSpindle(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out);
void judgeUnusedSpindle(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out);
void judgeReversedSpindle(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out);
void judgeFeedLimit(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out);
void judgeSidewaysDrill(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out);
void judgeAirCutting(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out);
void judgeRemoval(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out);
void judgeUnits(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out);
void judgeRoomBelow(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out);
void judgeFixtures(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out);
void judgeFixtureClearance(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out);
void judgeLoosePieces(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out);
void judgeClearance(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out);
void judgeDepth(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out);
void judgeEngagement(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out);
void judgeChips(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out);
void judgeSurfaceSpeed(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out);
void judgeRemovalRate(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out);
void judgeFullSlots(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out);
void judgeEngagementJumps(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out);
void judgeToolFeed(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out);
void judgeToolSpindle(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out);
void judgeSpindleLimit(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out);
void judgeRamps(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out);
void judgeTapFeed(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out);
void judgeTravel(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out);
void judgeToolChanges(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out);
void judgeHolderClearance(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out);
void judgeShankClearance(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out);
void judgeTapOut(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out);

void needForStoppedSpindle(const CheckedRun& run, const RuleLimits& limits, BlockSet& out);
void needForReversedSpindle(const CheckedRun& run, const RuleLimits& limits, BlockSet& out);
void needForSidewaysDrill(const CheckedRun& run, const RuleLimits& limits, BlockSet& out);
void needForAirCutting(const CheckedRun& run, const RuleLimits& limits, BlockSet& out);
void needForRemoval(const CheckedRun& run, const RuleLimits& limits, BlockSet& out);
void needForDepth(const CheckedRun& run, const RuleLimits& limits, BlockSet& out);
void needForEngagement(const CheckedRun& run, const RuleLimits& limits, BlockSet& out);
void needForChips(const CheckedRun& run, const RuleLimits& limits, BlockSet& out);
void needForSurfaceSpeed(const CheckedRun& run, const RuleLimits& limits, BlockSet& out);
void needForRemovalRate(const CheckedRun& run, const RuleLimits& limits, BlockSet& out);
void needForFullSlots(const CheckedRun& run, const RuleLimits& limits, BlockSet& out);
void needForToolFeed(const CheckedRun& run, const RuleLimits& limits, BlockSet& out);
void needForToolSpindle(const CheckedRun& run, const RuleLimits& limits, BlockSet& out);
void needForRamps(const CheckedRun& run, const RuleLimits& limits, BlockSet& out);
void needForTaps(const CheckedRun& run, const RuleLimits& limits, BlockSet& out);

} // namespace proveout
