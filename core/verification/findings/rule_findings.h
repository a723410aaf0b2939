// SPDX-License-Identifier: GPL-3.0-or-later
// Findings of the rules: what is judged once a program has been run. The first argument of a sentence is the
// value that was found, the second the limit. The window does not show them yet, so they are not marked for
// translation.
#pragma once

#include <array>

#include "core/base/finding_row.h"

namespace proveout::rule_finding {

inline constexpr FindingRow kSpindleStopped{Severity::fault,
                                            false,
                                            "spindle-stopped",
                                            "Spindle stopped",
                                            "The cutter cuts {} mm deep while the spindle is stopped.",
                                            "Program M3 with a speed S before the cut."};
inline constexpr FindingRow kSpindleReversed{
    Severity::fault,
    false,
    "spindle-reversed",
    "Spindle reversed",
    "The cutter cuts {} mm deep while the spindle turns counterclockwise (M4).",
    "Program M3, or use a left-hand tool and turn this rule off."};
inline constexpr FindingRow kFeedLimit{
    Severity::warning,
    false,
    "feed-limit",
    "Feed rate too high",
    "The feed rate of {} mm/min is above the maximum of the machine, {} mm/min.",
    "Reduce F, or correct the machine values."};
inline constexpr FindingRow kDrillSideways{
    Severity::fault,
    false,
    "plunge-not-allowed",
    "Motion not allowed for tool",
    "The tool moves sideways in material, {} mm deep, but only cuts along its axis.",
    "Retract above the hole before moving in X or Y, or choose a milling cutter.",
    SeverityRule::warningIfAssumed};
inline constexpr FindingRow kNothingCut{
    Severity::error,
    true,
    "nothing-cut",
    "Nothing cut",
    "The program does not touch the stock.",
    "Check the position and the size of the stock, the work offset and the tools."};
inline constexpr FindingRow kHardlyCuts{
    Severity::error,
    true,
    "nothing-cut",
    "Nothing cut",
    "The program removes only {} % of the stock, less than {} %.",
    "Check the position and the size of the stock, the work offset and the tools."};
inline constexpr FindingRow kUnitsTooLarge{
    Severity::warning,
    true,
    "units-suspect",
    "Wrong unit suspected",
    "The cuts extend over {} times the size of the stock, about as many as an inch has "
    "millimetres.",
    "Check G20 and G21, and the unit of the stock."};
inline constexpr FindingRow kUnitsTooSmall{
    Severity::warning,
    true,
    "units-suspect",
    "Wrong unit suspected",
    "The stock is {} times the size of the cuts, about as many as an inch has "
    "millimetres.",
    "Check G20 and G21, and the unit of the stock."};
inline constexpr FindingRow kTableCollision{
    Severity::fault,
    false,
    "table-collision",
    "Cutter below stock",
    "The cutter goes {} mm below the bottom of the stock; {} mm are allowed.",
    "Raise the cut, place the stock higher, or allow more if there is room below."};
inline constexpr FindingRow kFixtureCollision{
    Severity::fault,
    false,
    "fixture-collision",
    "Fixture collision",
    "The tool collides with the fixture \"{3}\", {1} mm deep.",
    "Move the fixture, or retract higher before the tool passes it."};
inline constexpr FindingRow kFixtureNear{
    Severity::warning,
    false,
    "fixture-near",
    "Fixture too near",
    "The tool passes nearer than {2} mm to the fixture \"{3}\", by {1} mm.",
    "Move the fixture, retract higher, or allow less clearance."};
inline constexpr FindingRow kLoosePiece{Severity::fault,
                                        false,
                                        "loose-piece",
                                        "Piece comes loose",
                                        "A piece of {} mm³ has come loose from the rest of the stock.",
                                        "Leave tabs, or turn this rule off if the piece is held."};
inline constexpr FindingRow kAirCutting{
    Severity::note,
    false,
    "air-cutting",
    "Feeding in air",
    "The cutter moves through air at feed for {} s; up to {} s are not reported.",
    "Approach with G0 where it is safe."};

inline constexpr std::array kRuleRows{&kSpindleStopped, &kSpindleReversed,  &kFeedLimit,     &kDrillSideways,
                                      &kNothingCut,     &kHardlyCuts,       &kUnitsTooLarge, &kUnitsTooSmall,
                                      &kTableCollision, &kFixtureCollision, &kFixtureNear,   &kLoosePiece,
                                      &kAirCutting};

} // namespace proveout::rule_finding
