// SPDX-License-Identifier: GPL-3.0-or-later
// Findings of the rules: what is judged once a program has been run. The first argument of a sentence is the
// value that was found, the second the limit.
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::rule_finding {

inline constexpr FindingRow kSpindleStopped{
    Severity::fault,
    false,
    "spindle-stopped",
    PROVEOUT_TEXT("Core", "Spindle stopped"),
    PROVEOUT_TEXT("Core", "The cutter cuts {} mm deep while the spindle is stopped."),
    PROVEOUT_TEXT("Core", "Program M3 with a speed S before the cut.")};
inline constexpr FindingRow kSpindleNeverTurns{
    Severity::warning,
    true,
    "spindle-never-turns",
    PROVEOUT_TEXT("Core", "Spindle never turns"),
    PROVEOUT_TEXT("Core", "The cutter cuts {} mm deep, but the program never turns the spindle at a speed."),
    PROVEOUT_TEXT("Core", "Program M3 with a speed S, or make sure that the spindle turns.")};
inline constexpr FindingRow kSpindleReversed{
    Severity::fault,
    false,
    "spindle-reversed",
    PROVEOUT_TEXT("Core", "Spindle reversed"),
    PROVEOUT_TEXT("Core", "The cutter cuts {} mm deep while the spindle turns counterclockwise (M4)."),
    PROVEOUT_TEXT("Core", "Program M3, or use a left-hand tool and turn this rule off.")};
inline constexpr FindingRow kFeedLimit{
    Severity::warning,
    false,
    "feed-limit",
    PROVEOUT_TEXT("Core", "Feed rate too high"),
    PROVEOUT_TEXT("Core", "The feed rate of {} mm/min is above the maximum of the machine, {} mm/min."),
    PROVEOUT_TEXT("Core", "Reduce F, or correct the machine values.")};
inline constexpr FindingRow kDrillSideways{
    Severity::fault,
    false,
    "plunge-not-allowed",
    PROVEOUT_TEXT("Core", "Motion not allowed for tool"),
    PROVEOUT_TEXT("Core", "The tool moves sideways in material, {} mm deep, but only cuts along its axis."),
    PROVEOUT_TEXT("Core", "Retract above the hole before moving in X or Y, or choose a milling cutter."),
    SeverityRule::warningIfAssumed};
inline constexpr FindingRow kDrillSidewaysUnconfirmed{
    Severity::warning,
    true,
    "plunge-not-allowed",
    PROVEOUT_TEXT("Core", "Motion not allowed for tool"),
    PROVEOUT_TEXT(
        "Core", "The unconfirmed tool moves sideways in material, {} mm deep, but only cuts along its axis."),
    PROVEOUT_TEXT("Core", "Confirm the tool in the tool table, or choose another shape.")};
inline constexpr FindingRow kNothingCut{
    Severity::error,
    true,
    "nothing-cut",
    PROVEOUT_TEXT("Core", "Nothing cut"),
    PROVEOUT_TEXT("Core", "The program does not touch the stock."),
    PROVEOUT_TEXT("Core", "Check the position and the size of the stock, the work offset and the tools.")};
inline constexpr FindingRow kHardlyCuts{
    Severity::error,
    true,
    "nothing-cut",
    PROVEOUT_TEXT("Core", "Nothing cut"),
    PROVEOUT_TEXT("Core", "The program removes only {} % of the stock, less than {} %."),
    PROVEOUT_TEXT("Core", "Check the position and the size of the stock, the work offset and the tools.")};
inline constexpr FindingRow kUnitsTooLarge{
    Severity::warning,
    true,
    "units-suspect",
    PROVEOUT_TEXT("Core", "Wrong unit suspected"),
    PROVEOUT_TEXT("Core", "The cuts extend over {} times the size of the stock, about as many as an inch has "
                          "millimetres."),
    PROVEOUT_TEXT("Core", "Check G20 and G21, and the unit of the stock.")};
inline constexpr FindingRow kUnitsTooSmall{
    Severity::warning,
    true,
    "units-suspect",
    PROVEOUT_TEXT("Core", "Wrong unit suspected"),
    PROVEOUT_TEXT("Core", "The stock is {} times the size of the cuts, about as many as an inch has "
                          "millimetres."),
    PROVEOUT_TEXT("Core", "Check G20 and G21, and the unit of the stock.")};
inline constexpr FindingRow kTableCollision{
    Severity::fault,
    false,
    "table-collision",
    PROVEOUT_TEXT("Core", "Cutter below stock"),
    PROVEOUT_TEXT("Core", "The cutter goes {} mm below the bottom of the stock; {} mm are allowed."),
    PROVEOUT_TEXT("Core", "Raise the cut, place the stock higher, or allow more if there is room below.")};
inline constexpr FindingRow kFixtureCollision{
    Severity::fault,
    false,
    "fixture-collision",
    PROVEOUT_TEXT("Core", "Fixture collision"),
    PROVEOUT_TEXT("Core", "The tool collides with the fixture \"{3}\", {1} mm deep."),
    PROVEOUT_TEXT("Core", "Move the fixture, or retract higher before the tool passes it.")};
inline constexpr FindingRow kFixtureNear{
    Severity::warning,
    false,
    "fixture-near",
    PROVEOUT_TEXT("Core", "Fixture too near"),
    PROVEOUT_TEXT("Core", "The tool passes nearer than {2} mm to the fixture \"{3}\", by {1} mm."),
    PROVEOUT_TEXT("Core", "Move the fixture, retract higher, or allow less clearance.")};
inline constexpr FindingRow kLoosePiece{
    Severity::fault,
    false,
    "loose-piece",
    PROVEOUT_TEXT("Core", "Piece comes loose"),
    PROVEOUT_TEXT("Core", "A piece of {} mm³ has come loose from the rest of the stock."),
    PROVEOUT_TEXT("Core", "Leave tabs, or turn this rule off if the piece is held.")};
inline constexpr FindingRow kAirCutting{
    Severity::note,
    false,
    "air-cutting",
    PROVEOUT_TEXT("Core", "Feeding in air"),
    PROVEOUT_TEXT("Core", "The cutter moves through air at feed for {} s; up to {} s are not reported."),
    PROVEOUT_TEXT("Core", "Approach with G0 where it is safe.")};

inline constexpr FindingRow kRapidTooClose{
    Severity::warning,
    false,
    "rapid-too-close",
    PROVEOUT_TEXT("Core", "Rapid close to stock"),
    PROVEOUT_TEXT("Core", "The rapid move passes the stock {} mm closer than the clearance of {} mm."),
    PROVEOUT_TEXT("Core", "Retract higher before the rapid, or reduce rapidClearance.")};
inline constexpr FindingRow kDepthLimit{
    Severity::fault,
    false,
    "depth-limit",
    PROVEOUT_TEXT("Core", "Axial depth too large"),
    PROVEOUT_TEXT("Core", "The axial depth of cut of {} mm is above the maximum of the tool, {} mm."),
    PROVEOUT_TEXT("Core", "Cut in shallower passes, or choose another tool.")};
inline constexpr FindingRow kEngagementLimit{
    Severity::fault,
    false,
    "engagement-limit",
    PROVEOUT_TEXT("Core", "Radial engagement too large"),
    PROVEOUT_TEXT("Core", "The radial engagement of {} mm is above the maximum of the tool, {} mm."),
    PROVEOUT_TEXT("Core", "Reduce the stepover, clear corners first, or choose another tool.")};
inline constexpr FindingRow kEngagementJump{
    Severity::note,
    false,
    "engagement-jump",
    PROVEOUT_TEXT("Core", "Radial engagement jumps"),
    PROVEOUT_TEXT("Core", "From one block to the next the radial engagement more than "
                          "doubles, to {} mm; the maximum of the tool is {} mm."),
    PROVEOUT_TEXT("Core", "Round the corner, or clear it first.")};
inline constexpr FindingRow kFullSlot{
    Severity::note,
    false,
    "full-slot",
    PROVEOUT_TEXT("Core", "Slot of full width"),
    PROVEOUT_TEXT(
        "Core",
        "The tool cuts {} mm wide, a slot of its full diameter, {} mm; no radial limit is stated for it."),
    PROVEOUT_TEXT("Core", "State maxae for the tool if it may not, or turn this rule off.")};
inline constexpr FindingRow kChipLimit{
    Severity::fault,
    false,
    "chip-limit",
    PROVEOUT_TEXT("Core", "Chips too thick"),
    PROVEOUT_TEXT("Core", "The chip thickness of {} mm is above the maximum of the tool, {} mm."),
    PROVEOUT_TEXT("Core", "Reduce the feed rate, or raise the spindle speed.")};
inline constexpr FindingRow kSurfaceSpeed{
    Severity::fault,
    false,
    "surface-speed",
    PROVEOUT_TEXT("Core", "Surface speed too high"),
    PROVEOUT_TEXT("Core", "The surface speed of {} m/min is above the maximum of the tool, {} m/min."),
    PROVEOUT_TEXT("Core", "Reduce the spindle speed.")};
inline constexpr FindingRow kRemovalRate{
    Severity::fault,
    false,
    "removal-rate-limit",
    PROVEOUT_TEXT("Core", "Removal rate too high"),
    PROVEOUT_TEXT("Core", "The tool removes {} cm³/min; its maximum is {} cm³/min."),
    PROVEOUT_TEXT("Core", "Reduce the feed rate, the depth or the stepover.")};
inline constexpr FindingRow kToolFeedLimit{
    Severity::fault,
    false,
    "tool-feed-limit",
    PROVEOUT_TEXT("Core", "Feed above tool maximum"),
    PROVEOUT_TEXT("Core", "The tool cuts at a feed rate of {} mm/min; its maximum is {} mm/min."),
    PROVEOUT_TEXT("Core", "Reduce F, or correct maxfeed of the tool.")};
inline constexpr FindingRow kToolSpindleLimit{
    Severity::fault,
    false,
    "tool-spindle-limit",
    PROVEOUT_TEXT("Core", "Spindle above tool maximum"),
    PROVEOUT_TEXT("Core", "The tool turns at {} rpm; its maximum is {} rpm."),
    PROVEOUT_TEXT("Core", "Reduce S, or correct maxrpm of the tool.")};
inline constexpr FindingRow kSpindleLimit{
    Severity::warning,
    false,
    "spindle-limit",
    PROVEOUT_TEXT("Core", "Spindle speed too high"),
    PROVEOUT_TEXT("Core", "The spindle speed of {} rpm is above the maximum of the machine, {} rpm."),
    PROVEOUT_TEXT("Core", "Reduce S, or correct the machine values.")};
inline constexpr FindingRow kRampTooSteep{
    Severity::fault,
    false,
    "ramp-too-steep",
    PROVEOUT_TEXT("Core", "Ramp too steep"),
    PROVEOUT_TEXT("Core", "The tool goes down into material at {}°; its steepest ramp is {}°."),
    PROVEOUT_TEXT("Core", "Lengthen the ramp or the helix, or drill a hole for the tool first.")};
inline constexpr FindingRow kTapFeed{
    Severity::fault,
    false,
    "tap-feed",
    PROVEOUT_TEXT("Core", "Tap out of step"),
    PROVEOUT_TEXT(
        "Core", "The tap moves at a feed rate of {} mm/min; its pitch and the spindle speed need {} mm/min."),
    PROVEOUT_TEXT("Core", "Program F as pitch times spindle speed, or the pitch in G95.")};
inline constexpr FindingRow kTapNotReversed{
    Severity::fault,
    false,
    "tap-not-reversed",
    PROVEOUT_TEXT("Core", "Tap not reversed"),
    PROVEOUT_TEXT("Core", "The tap is retracted from a thread {} mm deep without reversing the spindle."),
    PROVEOUT_TEXT("Core", "Tap with G84, G74 or G33.1; turn this rule off for a reversing tap holder.")};

inline constexpr FindingRow kTravelLimit{
    Severity::fault,
    false,
    "travel-limit",
    PROVEOUT_TEXT("Core", "Beyond the travel"),
    PROVEOUT_TEXT("Core", "{3} moves {1} mm beyond its travel limit, {2} mm in machine coordinates."),
    PROVEOUT_TEXT("Core", "Place the part elsewhere, turn it, or shorten the motion.")};

inline constexpr FindingRow kToolChangePosition{
    Severity::fault,
    false,
    "tool-change-position",
    PROVEOUT_TEXT("Core", "Tool change elsewhere"),
    PROVEOUT_TEXT("Core",
                  "{3} is {1} mm away from the tool change position, {2} mm in machine coordinates, when "
                  "the tool is changed."),
    PROVEOUT_TEXT("Core", "Move there before M6, for example with G28 or G53.")};
/// Arguments: by how much it is nearer, the clearance, the uncertainty of the grid.
inline constexpr FindingRow kHolderNear{
    Severity::warning,
    false,
    "holder-near",
    PROVEOUT_TEXT("Core", "Holder close to stock"),
    PROVEOUT_TEXT("Core",
                  "The holder passes nearer than {2} mm to the stock, by {1} mm. To the sides, up to {3} mm "
                  "of this may be due to the grid."),
    PROVEOUT_TEXT("Core",
                  "Extend the tool, choose a slimmer holder or a finer grid, or reduce holderClearance.")};
inline constexpr FindingRow kShankNear{
    Severity::warning,
    false,
    "shank-near",
    PROVEOUT_TEXT("Core", "Shank close to stock"),
    PROVEOUT_TEXT("Core",
                  "The shank passes nearer than {2} mm to the stock, by {1} mm. To the sides, up to {3} mm "
                  "of this may be due to the grid."),
    PROVEOUT_TEXT("Core", "Choose a tool with longer flutes or a finer grid, or reduce holderClearance.")};

inline constexpr FindingRow kCommentDiameter{
    Severity::warning,
    false,
    "tool-comment-differs",
    PROVEOUT_TEXT("Core", "Tool differs from comment"),
    PROVEOUT_TEXT("Core", "The comment describes T{} as ⌀ {} mm; the tool table has ⌀ {} mm."),
    PROVEOUT_TEXT("Core", "Load the tool that the program was made for, or correct the comment.")};
inline constexpr FindingRow kCommentShape{
    Severity::warning,
    false,
    "tool-comment-differs",
    PROVEOUT_TEXT("Core", "Tool differs from comment"),
    PROVEOUT_TEXT("Core", "The comment describes T{} as “{}”; the tool table has “{}”."),
    kCommentDiameter.hint};

inline constexpr std::array kRuleRows{&kSpindleStopped,   &kSpindleNeverTurns, &kSpindleReversed,
                                      &kFeedLimit,        &kDrillSideways,     &kDrillSidewaysUnconfirmed,
                                      &kNothingCut,       &kHardlyCuts,        &kUnitsTooLarge,
                                      &kUnitsTooSmall,    &kTableCollision,    &kFixtureCollision,
                                      &kFixtureNear,      &kLoosePiece,        &kAirCutting,
                                      &kRapidTooClose,    &kDepthLimit,        &kEngagementLimit,
                                      &kEngagementJump,   &kFullSlot,          &kChipLimit,
                                      &kSurfaceSpeed,     &kRemovalRate,       &kToolFeedLimit,
                                      &kToolSpindleLimit, &kSpindleLimit,      &kRampTooSteep,
                                      &kTapFeed,          &kTapNotReversed,    &kTravelLimit,
                                      &kCommentDiameter,  &kCommentShape,      &kToolChangePosition,
                                      &kHolderNear,       &kShankNear};

} // namespace proveout::rule_finding
