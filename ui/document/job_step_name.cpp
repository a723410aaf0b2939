// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/job_step_name.h"

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <QCoreApplication>

#include "core/base/field.h"
#include "core/formats/stock_shapes.h"
#include "core/simulation/setup/setup_fields.h"
#include "ui/look/diagnostic_text.h"

namespace proveout {

namespace {

// Field numbers: each group has its own range.
constexpr int kSetupFields = 0;
constexpr int kStockSizes = 100;
constexpr int kParameterFields = 200;
constexpr int kMachineFields = 300;
constexpr int kFixtures = 400; // plus the position among the names
constexpr int kMostFixtures = 500;
constexpr int kLimitFields = 900;
constexpr int kPartFields = 950;
constexpr int kTools = 1000; // plus the tool number

QString translated(const char* text) {
    return QCoreApplication::translate("JobSteps", text);
}

/// A field of the stock that every shape has.
struct StockPart {
    const char* name;
    bool (*same)(const Setup& a, const Setup& b);
};

constexpr std::array<StockPart, 4> kStock{{
    {setup_field::kMinX.label,
     [](const Setup& a, const Setup& b) { return a.stock.corner.x == b.stock.corner.x; }},
    {setup_field::kMinY.label,
     [](const Setup& a, const Setup& b) { return a.stock.corner.y == b.stock.corner.y; }},
    {setup_field::kTopZ.label,
     [](const Setup& a, const Setup& b) { return a.stock.corner.z == b.stock.corner.z; }},
    {QT_TRANSLATE_NOOP("Core", "Stock shape"),
     [](const Setup& a, const Setup& b) {
         return a.shape.kind == b.shape.kind && a.shape.file == b.shape.file;
     }},
}};

/// An automatic spacing changes with other fields and is not a change of its own.
bool sameValue(const GridPlace<const double, const bool>& a, const GridPlace<const double, const bool>& b) {
    return a.automatic == b.automatic && (a.automatic || a.spacing == b.spacing);
}

template<class Value>
bool sameValue(const Value& a, const Value& b) {
    return a == b;
}

/// What differs, and whether all of it belongs to the stock.
struct Differences {
    std::vector<JobStepName> names;
    bool onlyStock = true;

    void add(const QString& text, int field, bool ofStock) {
        names.push_back({text, field});
        onlyStock = onlyStock && ofStock;
    }
};

/// Lengths and choices of the shape, if its kind stays the same.
void addStockSizes(const Setup& before, const Setup& after, Differences& found) {
    if (before.shape.kind != after.shape.kind)
        return;
    const StockSpec a{before.stock, before.shape};
    const StockSpec b{after.stock, after.shape};
    int index = kStockSizes;
    for (const StockField& field : rowOf(after.shape.kind).fields) {
        const auto* length = std::get_if<StockLength>(&field.value);
        const auto* choice = std::get_if<StockChoice>(&field.value);
        if ((length != nullptr && length->get(a) != length->get(b)) ||
            (choice != nullptr && choice->get(a) != choice->get(b)))
            found.add(coreText(field.label), index, true);
        ++index;
    }
}

void addTools(const ToolTable& before, const ToolTable& after, Differences& found) {
    std::set<int> numbers;
    for (const ToolTable* table : {&before, &after}) {
        const ToolTable& other = table == &before ? after : before;
        for (const auto& [number, cutter] : table->tools()) {
            const Cutter* there = other.find(number);
            const ToolOrigin* origin = table->unconfirmedOrigin(number);
            const ToolOrigin* thereOrigin = other.unconfirmedOrigin(number);
            const bool sameOrigin = (origin == nullptr) == (thereOrigin == nullptr);
            if (there == nullptr || !(*there == cutter) || !sameOrigin)
                numbers.insert(number);
        }
    }
    if (numbers.size() == 1)
        found.add(translated(QT_TRANSLATE_NOOP("JobSteps", "Tool T%1")).arg(*numbers.begin()),
                  kTools + *numbers.begin(), false);
    else if (!numbers.empty())
        found.add(translated(QT_TRANSLATE_NOOP("JobSteps", "Tool table")), -1, false);
}

void addFixtures(const Fixtures& before, const Fixtures& after, Differences& found) {
    std::set<std::string> names;
    for (const Fixtures* fixtures : {&before, &after})
        for (const auto& named : *fixtures)
            names.insert(named.first);
    std::vector<JobStepName> changed;
    int index = 0;
    for (const std::string& name : names) {
        const auto was = before.find(name);
        const auto is = after.find(name);
        const bool both = was != before.end() && is != after.end();
        if (!both || was->second != is->second)
            changed.push_back(
                {translated(QT_TRANSLATE_NOOP("JobSteps", "Fixture %1")).arg(QString::fromStdString(name)),
                 both ? kFixtures + index % kMostFixtures : -1});
        ++index;
    }
    if (changed.size() == 1)
        found.add(changed.front().text, changed.front().field, false);
    else if (!changed.empty())
        found.add(translated(QT_TRANSLATE_NOOP("JobSteps", "Fixtures")), -1, false);
}

JobStepName setupName(const Setup& before, const Setup& after) {
    Differences found;
    int index = kSetupFields;
    for (const StockPart& part : kStock) {
        if (!part.same(before, after))
            found.add(coreText(part.name), index, true);
        ++index;
    }
    const auto compare = [&](bool ofStock) {
        return [&, ofStock](auto place, const Field& field) {
            if (!sameValue(std::invoke(place, before), std::invoke(place, after)))
                found.add(coreText(field.label), index, ofStock);
            ++index;
        };
    };
    eachGridField(compare(true));
    eachControlField(compare(false));
    addStockSizes(before, after, found);
    addFixtures(before.fixtures, after.fixtures, found);
    addTools(before.tools, after.tools, found);
    if (found.names.size() == 1)
        return found.names.front();
    const bool stock = !found.names.empty() && found.onlyStock;
    return {
        translated(stock ? QT_TRANSLATE_NOOP("JobSteps", "Stock") : QT_TRANSLATE_NOOP("JobSteps", "Setup"))};
}

/// For a struct that has describe(); `several` is the name if more than one field differs.
template<class Params>
JobStepName fieldName(Params before, Params after, int firstField, const char* several) {
    std::vector<double> values;
    describe(before, [&](auto& value, const Field&) { values.push_back(static_cast<double>(value)); });
    std::vector<JobStepName> found;
    int index = 0;
    describe(after, [&](auto& value, const Field& field) {
        if (static_cast<double>(value) != values[static_cast<std::size_t>(index)])
            found.push_back({coreText(field.label), firstField + index});
        ++index;
    });
    return found.size() == 1 ? found.front() : JobStepName{translated(several)};
}

JobStepName checkName(const CheckRules& before, const CheckRules& after) {
    if (before.limits != after.limits)
        return fieldName(before.limits, after.limits, kLimitFields,
                         QT_TRANSLATE_NOOP("JobSteps", "Limits of rules"));
    if (before.off != after.off)
        return {translated(QT_TRANSLATE_NOOP("JobSteps", "Rules"))};
    return {translated(QT_TRANSLATE_NOOP("JobSteps", "Waiver"))};
}

JobStepName partName(const std::optional<PartSpec>& before, const std::optional<PartSpec>& after) {
    if (!before || !after || before->file != after->file)
        return {translated(QT_TRANSLATE_NOOP("JobSteps", "Design part"))};
    return fieldName(*before, *after, kPartFields, QT_TRANSLATE_NOOP("JobSteps", "Design part"));
}

} // namespace

JobStepName jobStepName(const JobValues& before, const JobValues& after) {
    // The region size may change with the z-map; if the setup differs too, the setup is what the user
    // changed.
    if (!(*before.setup == *after.setup))
        return setupName(*before.setup, *after.setup);
    if (!(before.parameters == after.parameters)) {
        // A change of the method also sets that method's defaults.
        if (before.parameters.method != after.parameters.method)
            return {translated(QT_TRANSLATE_NOOP("JobSteps", "Decimation method")), kParameterFields};
        return fieldName(before.parameters, after.parameters, kParameterFields,
                         QT_TRANSLATE_NOOP("JobSteps", "Decimation parameters"));
    }
    if (before.check != after.check)
        return checkName(before.check, after.check);
    if (before.part != after.part)
        return partName(before.part, after.part);
    return fieldName(before.machine.value_or(Machine()), after.machine.value_or(Machine()), kMachineFields,
                     QT_TRANSLATE_NOOP("JobSteps", "Machine"));
}

bool sameValues(const JobValues& a, const JobValues& b) {
    const bool sameSetup = a.setup == b.setup || *a.setup == *b.setup;
    return sameSetup && a.parameters == b.parameters && a.machine == b.machine && a.check == b.check &&
           a.part == b.part;
}

} // namespace proveout
