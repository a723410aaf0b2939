// SPDX-License-Identifier: GPL-3.0-or-later
// The table of rules: what is judged once a program has been run. A new rule is one row, its function, its
// finding and two programs in the tests.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "core/base/field.h"
#include "core/base/finding_row.h"
#include "core/base/work_context.h"
#include "core/verification/rules/checked_run.h"

namespace proveout {

/// The limits of the rules. Value type; mm, seconds, per cent.
struct RuleLimits {
    double leastRemoved = 0.1;
    double belowStock = 3;
    double airSeconds = 10;
    double looseVolume = 1;
    double fixtureClearance = 1;
    double tapFeedError = 1;
    double rapidClearance = 0; ///< 0: rapids may come as close as they like

    friend bool operator==(const RuleLimits&, const RuleLimits&) = default;
};

/// Visits every field once; see field.h.
template<ParametersOf<RuleLimits> Params, class Visitor>
void describe(Params& limits, Visitor&& visit) {
    visit(limits.leastRemoved,
          Field{.key = "leastRemoved",
                .label = "Least removal",
                .unit = "%",
                .help = "A program that removes less of the stock counts as not cutting.",
                .minimum = 0,
                .maximum = 100,
                .step = 0.1});
    visit(limits.belowStock, Field{.key = "belowStock",
                                   .label = "Room below stock",
                                   .unit = "mm",
                                   .help = "How far below the bottom of the stock a cutter may go.",
                                   .minimum = 0,
                                   .maximum = 1000,
                                   .step = 0.5});
    visit(limits.airSeconds, Field{.key = "airSeconds",
                                   .label = "Feeding in air",
                                   .unit = "s",
                                   .help = "Longer stretches of feeding in air are reported.",
                                   .minimum = 0,
                                   .maximum = 1e6,
                                   .step = 1});
    visit(limits.looseVolume, Field{.key = "looseVolume",
                                    .label = "Smallest loose piece",
                                    .unit = "mm³",
                                    .help = "Smaller pieces that come loose count as chips.",
                                    .minimum = 0,
                                    .maximum = 1e9,
                                    .step = 1});
    visit(limits.fixtureClearance,
          Field{.key = "fixtureClearance",
                .label = "Clearance of fixtures",
                .unit = "mm",
                .help = "A tool that comes nearer to a fixture is reported, across and upwards.",
                .minimum = 0,
                .maximum = 1000,
                .step = 0.5});
    visit(limits.tapFeedError, Field{.key = "tapFeedError",
                                     .label = "Feed of taps",
                                     .unit = "%",
                                     .help = "How far the feed of a tap may be from its pitch.",
                                     .minimum = 0,
                                     .maximum = 100,
                                     .step = 0.5});
    visit(limits.rapidClearance,
          Field{.key = "rapidClearance",
                .label = "Clearance of rapids",
                .unit = "mm",
                .help = "Rapids that pass less than this above the stock are reported; 0: none.",
                .minimum = 0,
                .maximum = 1000,
                .step = 0.5});
}

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
    std::optional<Vec3> place = {};
    std::string what =
        {}; ///< the thing, where the rule has several of them; the third argument of the sentence
};

/// Collects what the rules find; owned by one thread.
class RuleFindings {
public:
    /// A block breaks a rule. Blocks must come in order; the larger value is the worse one.
    void add(const FindingRow& row, std::size_t block, int tool, double value, double limit = 0,
             const std::string& what = {});
    /// Something that concerns no block.
    void add(const FindingRow& row, double value = 0, double limit = 0, std::optional<Vec3> place = {});
    [[nodiscard]] const std::vector<RuleFinding>& all() const { return m_all; }

private:
    std::vector<RuleFinding> m_all;
};

struct Rule {
    std::span<const FindingRow* const> rows; ///< its findings; all have one id, by which it is turned off
    const char* unit;                        ///< of their values
    void (*judge)(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out);

    [[nodiscard]] const char* id() const { return rows.front()->id; }
};

[[nodiscard]] std::span<const Rule> rules();
/// The unit of the values of a finding; empty if it is not of a rule.
[[nodiscard]] const char* unitOf(const FindingRow& row);

/// Judges a run by all rules whose ids are not in `off`, in the order of the table; stopped between two
/// rules, by those before it.
[[nodiscard]] std::vector<RuleFinding> judge(const CheckedRun& run, const RuleLimits& limits,
                                             const std::set<std::string>& off,
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
void judgeTapOut(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out);

} // namespace proveout
