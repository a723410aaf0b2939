// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verification/verdict/not_checked.h"

#include <algorithm>
#include <array>
#include <variant>

#include "core/base/text.h"
#include "core/cutter/gauge_length.h"

namespace proveout {

namespace {

bool lacksStock(const CheckScope& scope) {
    return !scope.hasStock;
}

bool fittedStock(const CheckScope& scope) {
    return scope.hasStock && scope.stockFitted;
}

bool knowsTravel(const CheckScope& scope, int axis) {
    return scope.machine != nullptr && scope.machine->programZero() && scope.machine->travel(axis);
}

bool lacksTravel(const CheckScope& scope) {
    return !scope.hasStock || !knowsTravel(scope, 0) || !knowsTravel(scope, 1) || !knowsTravel(scope, 2);
}

bool lacksMachine(const CheckScope& scope) {
    return scope.machine == nullptr;
}

bool lacksSpindleMaximum(const CheckScope& scope) {
    return scope.machine != nullptr && scope.machine->largestSpindle == 0;
}

bool lacksFixtures(const CheckScope& scope) {
    return scope.setup.fixtures.empty();
}

bool probes(const CheckScope& scope) {
    return scope.program.asksForStock();
}

bool stopsForTheOperator(const CheckScope& scope) {
    return std::ranges::any_of(scope.program.events(), [](const Event& event) {
        return std::holds_alternative<ProgramStop>(event.data);
    });
}

/// Whether a tool that the program uses has a cutter with the property.
template<class Property>
bool anyCutter(const CheckScope& scope, const Property& property) {
    const std::vector<Program::ToolRun> runs = scope.program.toolRuns();
    return std::ranges::any_of(runs, [&](const Program::ToolRun& run) {
        const Cutter* cutter = scope.setup.tools.find(scope.tools.tool(run.tool));
        return cutter != nullptr && property(*cutter);
    });
}

/// A z-map shows nothing below a head.
bool undercuts(const CheckScope& scope) {
    return anyCutter(scope, [](const Cutter& cutter) { return cutter.head().has_value(); });
}

bool lacksHolder(const CheckScope& scope) {
    return !scope.hasStock ||
           anyCutter(scope, [](const Cutter& cutter) { return cutter.body().holder.empty(); });
}

/// Whether Z is judged in machine coordinates.
bool needsLength(const CheckScope& scope) {
    return knowsTravel(scope, 2) ||
           (scope.machine != nullptr && scope.machine->programZero() && scope.machine->toolChange(2));
}

bool lacksLength(const CheckScope& scope) {
    return scope.hasStock && needsLength(scope) &&
           anyCutter(scope, [](const Cutter& cutter) { return !gaugeLength(&cutter); });
}

bool lacksShank(const CheckScope& scope) {
    return !scope.hasStock ||
           anyCutter(scope, [](const Cutter& cutter) { return !cutter.body().shankGiven; });
}

bool lacksToolLimits(const CheckScope& scope) {
    return !scope.hasStock ||
           anyCutter(scope, [](const Cutter& cutter) { return !cutter.data().limitsLoad(); });
}

constexpr std::array kRows{
    NotCheckedRow{"stock-not-given", PROVEOUT_TEXT("Core", "Everything that needs a stock"), lacksStock},
    NotCheckedRow{"stock-fitted",
                  PROVEOUT_TEXT("Core", "Size and position of the stock, which is fitted to the toolpath"),
                  fittedStock},
    NotCheckedRow{"holder-not-given", PROVEOUT_TEXT("Core", "Collisions of the tool holder"), lacksHolder},
    NotCheckedRow{"shank-not-given", PROVEOUT_TEXT("Core", "Collisions of the shank"), lacksShank},
    NotCheckedRow{"fixtures-not-given", PROVEOUT_TEXT("Core", "Collisions with fixtures"), lacksFixtures},
    NotCheckedRow{"travel-not-given", PROVEOUT_TEXT("Core", "Travel limits of the machine"), lacksTravel},
    NotCheckedRow{"tool-length-not-given", PROVEOUT_TEXT("Core", "Travel of Z with tools without a holder"),
                  lacksLength},
    NotCheckedRow{"machine-not-given",
                  PROVEOUT_TEXT("Core", "Maximum feed rate and spindle speed of the machine"), lacksMachine},
    NotCheckedRow{"largest-spindle-not-given", PROVEOUT_TEXT("Core", "Maximum spindle speed of the machine"),
                  lacksSpindleMaximum},
    NotCheckedRow{"tool-limits-not-given", PROVEOUT_TEXT("Core", "Load of the tools"), lacksToolLimits},
    NotCheckedRow{"undercuts", PROVEOUT_TEXT("Core", "Undercuts"), undercuts},
    NotCheckedRow{"probing", PROVEOUT_TEXT("Core", "Moves that depend on probing"), probes},
    NotCheckedRow{"manual-stops", PROVEOUT_TEXT("Core", "What the operator does at a program stop"),
                  stopsForTheOperator},
};

} // namespace

std::span<const NotCheckedRow> notCheckedRows() {
    return kRows;
}

void NotChecked::accept(const IdsWithReasons& ids) {
    const auto found = ids.find(row->id);
    accepted = found != ids.end();
    reason = accepted ? found->second : std::string();
}

std::vector<NotChecked> notChecked(const CheckScope& scope, const IdsWithReasons& accepted) {
    std::vector<NotChecked> entries;
    for (const NotCheckedRow& row : kRows)
        if (row.concerns(scope))
            entries.push_back({.row = &row});
    for (NotChecked& entry : entries)
        entry.accept(accepted);
    return entries;
}

} // namespace proveout
