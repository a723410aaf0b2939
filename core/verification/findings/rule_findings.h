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
inline constexpr FindingRow kDrillSidewaysUnconfirmed{
    Severity::warning,
    true,
    "plunge-not-allowed",
    "Motion not allowed for tool",
    "The unconfirmed tool moves sideways in material, {} mm deep, but only cuts along its axis.",
    "Confirm the tool in the tool table, or choose another shape."};
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

inline constexpr FindingRow kRapidTooClose{
    Severity::warning,
    false,
    "rapid-too-close",
    "Rapid close to stock",
    "The rapid move passes the stock {} mm closer than the clearance of {} mm.",
    "Retract higher before the rapid, or reduce rapidClearance."};
inline constexpr FindingRow kDepthLimit{
    Severity::fault,
    false,
    "depth-limit",
    "Axial depth too large",
    "The axial depth of cut of {} mm is above the maximum of the tool, {} mm.",
    "Cut in shallower passes, or choose another tool."};
inline constexpr FindingRow kEngagementLimit{
    Severity::fault,
    false,
    "engagement-limit",
    "Radial engagement too large",
    "The radial engagement of {} mm is above the maximum of the tool, {} mm.",
    "Reduce the stepover, clear corners first, or choose another tool."};
inline constexpr FindingRow kEngagementJump{Severity::note,
                                            false,
                                            "engagement-jump",
                                            "Radial engagement jumps",
                                            "From one block to the next the radial engagement more than "
                                            "doubles, to {} mm; the maximum of the tool is {} mm.",
                                            "Round the corner, or clear it first."};
inline constexpr FindingRow kFullSlot{
    Severity::note,
    false,
    "full-slot",
    "Slot of full width",
    "The tool cuts {} mm wide, a slot of its full diameter, {} mm; no radial limit is stated for it.",
    "State maxae for the tool if it may not, or turn this rule off."};
inline constexpr FindingRow kChipLimit{Severity::fault,
                                       false,
                                       "chip-limit",
                                       "Chips too thick",
                                       "The chip thickness of {} mm is above the maximum of the tool, {} mm.",
                                       "Reduce the feed rate, or raise the spindle speed."};
inline constexpr FindingRow kSurfaceSpeed{
    Severity::fault,
    false,
    "surface-speed",
    "Surface speed too high",
    "The surface speed of {} m/min is above the maximum of the tool, {} m/min.",
    "Reduce the spindle speed."};
inline constexpr FindingRow kRemovalRate{Severity::fault,
                                         false,
                                         "removal-rate-limit",
                                         "Removal rate too high",
                                         "The tool removes {} cm³/min; its maximum is {} cm³/min.",
                                         "Reduce the feed rate, the depth or the stepover."};
inline constexpr FindingRow kToolFeedLimit{
    Severity::fault,
    false,
    "tool-feed-limit",
    "Feed above tool maximum",
    "The tool cuts at a feed rate of {} mm/min; its maximum is {} mm/min.",
    "Reduce F, or correct maxfeed of the tool."};
inline constexpr FindingRow kToolSpindleLimit{Severity::fault,
                                              false,
                                              "tool-spindle-limit",
                                              "Spindle above tool maximum",
                                              "The tool turns at {} rpm; its maximum is {} rpm.",
                                              "Reduce S, or correct maxrpm of the tool."};
inline constexpr FindingRow kSpindleLimit{
    Severity::warning,
    false,
    "spindle-limit",
    "Spindle speed too high",
    "The spindle speed of {} rpm is above the maximum of the machine, {} rpm.",
    "Reduce S, or correct the machine values."};
inline constexpr FindingRow kRampTooSteep{
    Severity::fault,
    false,
    "ramp-too-steep",
    "Ramp too steep",
    "The tool goes down into material at {}°; its steepest ramp is {}°.",
    "Lengthen the ramp or the helix, or drill a hole for the tool first."};
inline constexpr FindingRow kTapFeed{
    Severity::fault,
    false,
    "tap-feed",
    "Tap out of step",
    "The tap moves at a feed rate of {} mm/min; its pitch and the spindle speed need {} mm/min.",
    "Program F as pitch times spindle speed, or the pitch in G95."};
inline constexpr FindingRow kTapNotReversed{
    Severity::fault,
    false,
    "tap-not-reversed",
    "Tap not reversed",
    "The tap is retracted from a thread {} mm deep without reversing the spindle.",
    "Tap with G84, G74 or G33.1; turn this rule off for a reversing tap holder."};

inline constexpr FindingRow kCommentDiameter{
    Severity::warning,
    false,
    "tool-comment-differs",
    "Tool differs from comment",
    "The comment describes T{} as ⌀ {} mm; the tool table has ⌀ {} mm.",
    "Load the tool that the program was made for, or correct the comment."};
inline constexpr FindingRow kCommentShape{Severity::warning,
                                          false,
                                          "tool-comment-differs",
                                          "Tool differs from comment",
                                          "The comment describes T{} as “{}”; the tool table has “{}”.",
                                          kCommentDiameter.hint};

inline constexpr std::array kRuleRows{
    &kSpindleStopped,   &kSpindleReversed, &kFeedLimit,      &kDrillSideways,    &kDrillSidewaysUnconfirmed,
    &kNothingCut,       &kHardlyCuts,      &kUnitsTooLarge,  &kUnitsTooSmall,    &kTableCollision,
    &kFixtureCollision, &kFixtureNear,     &kLoosePiece,     &kAirCutting,       &kRapidTooClose,
    &kDepthLimit,       &kEngagementLimit, &kEngagementJump, &kFullSlot,         &kChipLimit,
    &kSurfaceSpeed,     &kRemovalRate,     &kToolFeedLimit,  &kToolSpindleLimit, &kSpindleLimit,
    &kRampTooSteep,     &kTapFeed,         &kTapNotReversed, &kCommentDiameter,  &kCommentShape};

} // namespace proveout::rule_finding
