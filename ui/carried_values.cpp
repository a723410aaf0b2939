// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/carried_values.h"

#include <cstddef>
#include <set>
#include <type_traits>
#include <vector>

namespace proveout {

namespace {

/// Calls visit(a place in `now`, the same in `from`, in `to`) for the sizes of a box.
template<class Visit>
void visitBox(StockBox& now, const StockBox& from, const StockBox& to, Visit visit) {
    visit(now.corner.x, from.corner.x, to.corner.x);
    visit(now.corner.y, from.corner.y, to.corner.y);
    visit(now.corner.z, from.corner.z, to.corner.z);
    visit(now.width, from.width, to.width);
    visit(now.depth, from.depth, to.depth);
    visit(now.height, from.height, to.height);
}

/// A tool as the table has it: equal where cutter and origin are.
struct ToolEntry {
    const Cutter* cutter;
    const ToolOrigin* origin;

    ToolEntry(const ToolTable& table, int number)
        : cutter(table.find(number)), origin(table.unconfirmedOrigin(number)) {}

    friend bool operator==(const ToolEntry& a, const ToolEntry& b) {
        const auto same = [](const auto* one, const auto* other) {
            return one == nullptr || other == nullptr ? one == other : *one == *other;
        };
        return same(a.cutter, b.cutter) && same(a.origin, b.origin);
    }
};

void carryTools(ToolTable& now, const ToolTable& from, const ToolTable& to, Carry which) {
    std::set<int> numbers;
    for (const ToolTable* table : {&from, &to})
        for (const auto& row : table->tools())
            numbers.insert(row.first);
    for (const int number : numbers) {
        const ToolEntry before(from, number);
        const ToolEntry after(to, number);
        if (before == after || (which == Carry::whereSame && !(ToolEntry(now, number) == before)))
            continue;
        if (after.cutter == nullptr)
            now.remove(number);
        else
            now.set(number, *after.cutter, after.origin == nullptr ? ToolOrigin() : *after.origin);
    }
}

std::vector<double> valuesOf(DecimationParameters parameters) {
    std::vector<double> values;
    describe(parameters,
             [&values](const auto& value, const Field&) { values.push_back(static_cast<double>(value)); });
    return values;
}

} // namespace

DecimationParameters carried(DecimationParameters now, const DecimationParameters& from,
                             const DecimationParameters& to) {
    const std::vector<double> before = valuesOf(from);
    const std::vector<double> after = valuesOf(to);
    std::size_t index = 0;
    describe(now, [&](auto& place, const Field&) {
        using Value = std::remove_reference_t<decltype(place)>;
        if (before[index] != after[index]) {
            if constexpr (std::is_enum_v<Value>)
                place = static_cast<Value>(static_cast<int>(after[index]));
            else
                place = static_cast<Value>(after[index]);
        }
        ++index;
    });
    return now;
}

Setup carried(Setup now, const Setup& from, const Setup& to, Carry which) {
    const auto carry = [which](auto& place, const auto& before, const auto& after) {
        if (!(before == after) && (which == Carry::all || place == before))
            place = after;
    };
    // Every field: a new one does not compile until it is counted here, and carried below.
    [[maybe_unused]] const auto& [f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11] = now;
    const bool boxes = from.shape.body == nullptr && to.shape.body == nullptr && from.shape == to.shape;
    if (boxes)
        visitBox(now.stock, from.stock, to.stock, carry);
    else
        carry(now.stock, from.stock, to.stock); // which fits the body
    carry(now.shape, from.shape, to.shape);
    carry(now.automaticGrid, from.automaticGrid, to.automaticGrid);
    if (!now.automaticGrid)
        carry(now.spacing, from.spacing, to.spacing);
    carryTools(now.tools, from.tools, to.tools, which);
    carry(now.start, from.start, to.start);
    carry(now.startTool, from.startTool, to.startTool);
    carry(now.dialect, from.dialect, to.dialect);
    carry(now.blockDelete, from.blockDelete, to.blockDelete);
    carry(now.compensationTypeB, from.compensationTypeB, to.compensationTypeB);
    carry(now.ignoredM, from.ignoredM, to.ignoredM);
    return now;
}

} // namespace proveout
