// SPDX-License-Identifier: GPL-3.0-or-later
// By what a program is judged: limits of the rules, and what a person answers for. Part of a job.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/field.h"
#include "core/base/geometry.h"
#include "core/base/text.h"

namespace proveout {

/// The limits of the rules. Value type; mm, seconds, per cent.
struct RuleLimits {
    double leastRemoved = 0.1;
    double belowStock = 3;
    double airSeconds = 10;
    double looseVolume = 1;
    double fixtureClearance = 1;
    double tapFeedError = 1;
    double rapidClearance = 0;  ///< 0: rapids may come as close as they like
    double holderClearance = 0; ///< the same for shank and holder

    friend bool operator==(const RuleLimits&, const RuleLimits&) = default;
};

/// Visits every field once; see field.h.
template<ParametersOf<RuleLimits> Params, class Visitor>
void describe(Params& limits, Visitor&& visit) {
    visit(limits.leastRemoved,
          Field{.key = "leastRemoved",
                .label = PROVEOUT_TEXT("Core", "Least removal"),
                .unit = "%",
                .help =
                    PROVEOUT_TEXT("Core", "A program that removes less of the stock counts as not cutting."),
                .minimum = 0,
                .maximum = 100,
                .step = 0.1});
    visit(limits.belowStock,
          Field{.key = "belowStock",
                .label = PROVEOUT_TEXT("Core", "Room below stock"),
                .unit = "mm",
                .help = PROVEOUT_TEXT("Core", "How far below the bottom of the stock a cutter may go."),
                .minimum = 0,
                .maximum = 1000,
                .step = 0.5});
    visit(limits.airSeconds,
          Field{.key = "airSeconds",
                .label = PROVEOUT_TEXT("Core", "Feeding in air"),
                .unit = "s",
                .help = PROVEOUT_TEXT("Core", "Longer stretches of feeding in air are reported."),
                .minimum = 0,
                .maximum = 1e6,
                .step = 1});
    visit(limits.looseVolume,
          Field{.key = "looseVolume",
                .label = PROVEOUT_TEXT("Core", "Smallest loose piece"),
                .unit = "mm³",
                .help = PROVEOUT_TEXT("Core", "Smaller pieces that come loose count as chips."),
                .minimum = 0,
                .maximum = 1e9,
                .step = 1});
    visit(limits.fixtureClearance,
          Field{.key = "fixtureClearance",
                .label = PROVEOUT_TEXT("Core", "Clearance of fixtures"),
                .unit = "mm",
                .help = PROVEOUT_TEXT(
                    "Core", "A tool that comes nearer to a fixture is reported, across and upwards."),
                .minimum = 0,
                .maximum = 1000,
                .step = 0.5});
    visit(limits.tapFeedError,
          Field{.key = "tapFeedError",
                .label = PROVEOUT_TEXT("Core", "Feed of taps"),
                .unit = "%",
                .help = PROVEOUT_TEXT("Core", "How far the feed of a tap may be from its pitch."),
                .minimum = 0,
                .maximum = 100,
                .step = 0.5});
    visit(limits.rapidClearance,
          Field{.key = "rapidClearance",
                .label = PROVEOUT_TEXT("Core", "Clearance of rapids"),
                .unit = "mm",
                .help = PROVEOUT_TEXT(
                    "Core", "Rapids that pass less than this above the stock are reported; 0: none."),
                .minimum = 0,
                .maximum = 1000,
                .step = 0.5});
    visit(limits.holderClearance,
          Field{.key = "holderClearance",
                .label = PROVEOUT_TEXT("Core", "Clearance of holders"),
                .unit = "mm",
                .help = PROVEOUT_TEXT(
                    "Core", "A shank or holder that comes nearer to the stock is reported; 0: none."),
                .minimum = 0,
                .maximum = 1000,
                .step = 0.5});
}

/// A finding that a person answers for, so that it does not count in the verdict. It names what was found: if
/// block, size, tool or cutter change, the finding counts again. Value type.
struct Waiver {
    std::string finding = {};       ///< id
    int tool = 0;                   ///< of its blocks
    std::size_t count = 1;          ///< of blocks, of all findings that say the same
    std::string values = {};        ///< the values of its sentence
    std::optional<Vec3> place = {}; ///< program coordinates; none: it has no place
    std::string reason = {};
    std::string owner = {};  ///< who answers for it
    std::string cutter = {}; ///< the spec of the tool; empty: any cutter

    friend bool operator==(const Waiver&, const Waiver&) = default;
};

/// Ids, each with the reason why, which may be empty.
using IdsWithReasons = std::map<std::string, std::string>;

/// "full-slot:T3"
[[nodiscard]] inline std::string ruleForTool(std::string_view rule, int tool) {
    return std::string(rule) + ":T" + std::to_string(tool);
}
/// The rule of an id of CheckRules::off.
[[nodiscard]] constexpr std::string_view ruleOf(std::string_view off) {
    return off.substr(0, off.find(':'));
}

/// A limit of one rule for one tool: "table-collision:T3.belowStock". Value type.
struct LimitOfTool {
    std::string rule = {};
    int tool = 0;
    std::string key = {}; ///< of RuleLimits
};
/// Nothing if a text is not written like this, or RuleLimits has no such key.
[[nodiscard]] std::optional<LimitOfTool> parseLimitOfTool(std::string_view text);
/// The description of a limit; nothing if there is none with this key.
[[nodiscard]] std::optional<Field> limitField(std::string_view key);

/// Value type; read by several threads at once.
struct CheckRules {
    RuleLimits limits = {};
    IdsWithReasons off = {};      ///< rules: "full-slot"; for one tool: "full-slot:T3"
    IdsWithReasons accepted = {}; ///< entries of notCheckedRows()
    std::vector<Waiver> waivers = {};
    /// By names that parseLimitOfTool() reads; in place of those of `limits`.
    std::map<std::string, double> limitsOfTools = {};

    /// The limits of a rule for the tools that have limits of their own.
    [[nodiscard]] std::map<int, RuleLimits> limitsOf(std::string_view rule) const;
    /// Whether a condition holds for the limits of all tools, or for those of one with its own.
    template<class Condition>
    [[nodiscard]] bool any(const Condition& condition) const {
        if (condition(limits))
            return true;
        for (const auto& named : limitsOfTools)
            for (const auto& own : limitsOf(ruleOf(named.first)))
                if (condition(own.second))
                    return true;
        return false;
    }
    /// Whether the rule is turned off for this tool; 0: a finding that concerns no tool.
    [[nodiscard]] bool isOff(std::string_view rule, int tool = 0) const {
        return !off.empty() && (off.contains(std::string(rule)) || off.contains(ruleForTool(rule, tool)));
    }

    friend bool operator==(const CheckRules&, const CheckRules&) = default;
};

} // namespace proveout
