// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/carried_values.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

#include "core/simulation/setup/setup_fields.h"

namespace proveout {

namespace {

/// Calls visit(now, from, to) with the matching members of the three boxes, for each size of a box.
template<class Visit>
void visitBox(StockBox& now, const StockBox& from, const StockBox& to, Visit visit) {
    visit(now.corner.x, from.corner.x, to.corner.x);
    visit(now.corner.y, from.corner.y, to.corner.y);
    visit(now.corner.z, from.corner.z, to.corner.z);
    visit(now.width, from.width, to.width);
    visit(now.depth, from.depth, to.depth);
    visit(now.height, from.height, to.height);
}

/// An entry of the tool table. Entries are equal if cutter and origin are equal.
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

void carryFixtures(Fixtures& now, const Fixtures& from, const Fixtures& to, Carry which) {
    const auto entry = [](const Fixtures& fixtures, const std::string& name) {
        const auto found = fixtures.find(name);
        return found == fixtures.end() ? std::optional<Fixture>() : std::optional(found->second);
    };
    std::set<std::string> names;
    for (const Fixtures* fixtures : {&from, &to})
        for (const auto& named : *fixtures)
            names.insert(named.first);
    for (const std::string& name : names) {
        const std::optional<Fixture> before = entry(from, name);
        const std::optional<Fixture> after = entry(to, name);
        if (before == after || (which == Carry::whereSame && entry(now, name) != before))
            continue;
        if (after)
            now.insert_or_assign(name, *after);
        else
            now.erase(name);
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
    const bool boxes = from.shape.body == nullptr && to.shape.body == nullptr && from.shape == to.shape;
    if (boxes)
        visitBox(now.stock, from.stock, to.stock, carry);
    else
        carry(now.stock, from.stock, to.stock); // only if the stock still fits the body
    carry(now.shape, from.shape, to.shape);
    eachGridField([&](auto place, const Field&) {
        const auto grid = std::invoke(place, now);
        carry(grid.automatic, std::invoke(place, from).automatic, std::invoke(place, to).automatic);
        if (!grid.automatic)
            carry(grid.spacing, std::invoke(place, from).spacing, std::invoke(place, to).spacing);
    });
    carryFixtures(now.fixtures, from.fixtures, to.fixtures, which);
    carryTools(now.tools, from.tools, to.tools, which);
    eachControlField([&](auto place, const Field&) {
        carry(std::invoke(place, now), std::invoke(place, from), std::invoke(place, to));
    });
    return now;
}

} // namespace proveout
