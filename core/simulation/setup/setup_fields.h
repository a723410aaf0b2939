// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters of a setup: one row per parameter, read by the job file, the command line, the panels, undo
// and the guide's test. Stock shapes and the tool table have their own tables.
#pragma once

#include <array>
#include <functional>

#include "core/base/field.h"
#include "core/base/text.h"
#include "core/base/tool_number.h"
#include "core/nc/codes/ignored_codes.h"
#include "core/simulation/setup/setup.h"

namespace proveout::setup_field {

inline constexpr double kFarthest = 1e7; ///< mm; positions are within ± this

inline constexpr Field kMinX{.key = "minX",
                             .label = PROVEOUT_TEXT("Core", "Min X"),
                             .unit = "mm",
                             .help =
                                 PROVEOUT_TEXT("Core", "Program coordinate of the left side of the stock."),
                             .minimum = -kFarthest,
                             .maximum = kFarthest,
                             .step = 1};
inline constexpr Field kMinY{.key = "minY",
                             .label = PROVEOUT_TEXT("Core", "Min Y"),
                             .unit = "mm",
                             .help =
                                 PROVEOUT_TEXT("Core", "Program coordinate of the front side of the stock."),
                             .minimum = -kFarthest,
                             .maximum = kFarthest,
                             .step = 1};
inline constexpr Field kTopZ{.key = "topZ",
                             .label = PROVEOUT_TEXT("Core", "Top Z"),
                             .unit = "mm",
                             .help = PROVEOUT_TEXT("Core", "Program coordinate of the top of the stock."),
                             .minimum = -kFarthest,
                             .maximum = kFarthest,
                             .step = 1};

/// The range is for forms. Job file and command line leave the check to makeGrid(), which knows stock and
/// memory.
inline constexpr Field kGrid{
    .key = "grid",
    .label = PROVEOUT_TEXT("Core", "Grid spacing"),
    .unit = "mm",
    .help = PROVEOUT_TEXT(
        "Core", "Distance between the points of the z-map; adjusted so that it divides the stock exactly."),
    .minimum = 0.001,
    .maximum = 1000,
    .step = 0.1,
    .automatic =
        PROVEOUT_TEXT("Core", "One tenth of the smallest cutter diameter, with 1 to 4 million points"),
    .decimals = 4,
};
inline constexpr Field kStart{
    .key = "start",
    .label = PROVEOUT_TEXT("Core", "Start position"),
    .unit = "mm",
    .help = PROVEOUT_TEXT("Core",
                          "Program coordinates of the tool tip before the first block; unknown if not set."),
    .minimum = -kFarthest,
    .maximum = kFarthest,
    .step = 1};
inline constexpr Field kStartTool{
    .key = "startTool",
    .label = PROVEOUT_TEXT("Core", "Tool at start"),
    .unit = "",
    .help = PROVEOUT_TEXT(
        "Core",
        "Tool in the spindle before the first tool change; 0 is an empty spindle, or T0 of the tool table."),
    .minimum = kLeastTool,
    .maximum = kLargestTool,
    .step = 1,
    .option = "start-tool"};
/// The choices are the rows of dialects(), or "auto".
inline constexpr Field kDialect{
    .key = "dialect",
    .label = PROVEOUT_TEXT("Core", "Dialect of the program"),
    .unit = "",
    .help = PROVEOUT_TEXT("Core", "The control that the program is written for; arcs, cycles, offsets and "
                                  "numbers differ from control to control."),
    .automatic = PROVEOUT_TEXT("Core", "Detected from the program")};
inline constexpr Field kBlockDelete{
    .key = "blockDelete",
    .label = PROVEOUT_TEXT("Core", "Block delete (/)"),
    .unit = "",
    .help = PROVEOUT_TEXT("Core", "Skip blocks that start with /, like the switch on the control."),
    .option = "block-delete"};
/// The second choice is Setup::compensationTypeB.
inline constexpr std::array kCompensationChoices{
    Choice{"a", PROVEOUT_TEXT("Core", "Type A: straight to the path")},
    Choice{"b", PROVEOUT_TEXT("Core", "Type B: round outside corners")},
};
inline constexpr Field kCompensationStart{
    .key = "compensationStart",
    .label = PROVEOUT_TEXT("Core", "Cutter comp start-up"),
    .unit = "",
    .help = PROVEOUT_TEXT(
        "Core", "Start-up and cancel of Fanuc and Haas cutter compensation at outside corners, as set on the "
                "control (Fanuc parameter 5003 SUP, Haas setting 43): type A straight, type B round them."),
    .choices = kCompensationChoices,
    .option = "compensation-start"};
inline constexpr Field kIgnoredM{
    .key = "ignoredM",
    .label = PROVEOUT_TEXT("Core", "Ignored M codes"),
    .unit = "",
    .help = PROVEOUT_TEXT(
        "Core", "M codes that move no axis on this machine: clamps, doors, air, chip conveyor. They are "
                "ignored and listed as notes. Results after any other unknown code are unverified."),
    .minimum = 0,
    .maximum = kLargestMCode,
    .step = 1,
    .option = "ignore-m"};

} // namespace proveout::setup_field

namespace proveout {

/// The grid of a setup, one parameter of two members: without a spacing of its own it is automatic.
template<class Spacing, class Automatic>
struct GridPlace {
    Spacing& spacing;
    Automatic& automatic;
};
template<class Spacing, class Automatic>
GridPlace(Spacing&, Automatic&) -> GridPlace<Spacing, Automatic>;

/// Used like a pointer to a member.
struct GridOfSetup {
    template<ParametersOf<Setup> Params>
    constexpr auto operator()(Params& setup) const {
        return GridPlace{setup.spacing, setup.automaticGrid};
    }
};

/// Calls `visit(place, field)` for the parameters of the map; std::invoke(place, setup) is the value.
template<class Visitor>
void eachGridField(Visitor&& visit) {
    visit(GridOfSetup(), setup_field::kGrid);
}

/// The same for the settings of the control.
template<class Visitor>
void eachControlField(Visitor&& visit) {
    visit(&Setup::start, setup_field::kStart);
    visit(&Setup::startTool, setup_field::kStartTool);
    visit(&Setup::dialect, setup_field::kDialect);
    visit(&Setup::blockDelete, setup_field::kBlockDelete);
    visit(&Setup::compensationTypeB, setup_field::kCompensationStart);
    visit(&Setup::ignoredM, setup_field::kIgnoredM);
}

/// Visits the values themselves, as describe() does.
template<ParametersOf<Setup> Params, class Visitor>
void describeControl(Params& setup, Visitor&& visit) {
    eachControlField([&](auto place, const Field& field) { visit(std::invoke(place, setup), field); });
}

template<ParametersOf<Setup> Params, class Visitor>
void describeGrid(Params& setup, Visitor&& visit) {
    eachGridField([&](auto place, const Field& field) { visit(std::invoke(place, setup), field); });
}

/// Visits every parameter once; see field.h. The grid is a GridPlace.
template<ParametersOf<Setup> Params, class Visitor>
void describe(Params& setup, Visitor&& visit) {
    // Stock, shape, tools, fixtures, the two of the grid and six others: a new field does not compile until
    // it is counted here, and has its row above.
    [[maybe_unused]] const auto& [f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12] = setup;
    describeGrid(setup, visit);
    describeControl(setup, visit);
}

} // namespace proveout
