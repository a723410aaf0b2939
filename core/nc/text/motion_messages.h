// SPDX-License-Identifier: GPL-3.0-or-later
// Messages about positions, lines and arcs.
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::nc_message {

inline constexpr FindingRow kTargetTooFar{
    Severity::error,
    true,
    "target-too-far",
    PROVEOUT_TEXT("Core", "Target too far"),
    PROVEOUT_TEXT("Core", "The motion ends more than {} mm from machine zero, along {}."),
    PROVEOUT_TEXT("Core", "Check the values, the scaling and the repeats.")};
inline constexpr FindingRow kStartUnknown{
    Severity::warning,
    true,
    "start-unknown",
    PROVEOUT_TEXT("Core", "Start position unknown"),
    PROVEOUT_TEXT("Core", "{} position unknown; move not simulated."),
    PROVEOUT_TEXT("Core", "Position all axes with G0 before the first cut.")};
inline constexpr FindingRow kNeverKnown{
    Severity::warning,
    true,
    "position-never-known",
    PROVEOUT_TEXT("Core", "Axis never positioned"),
    PROVEOUT_TEXT("Core", "The program never positions {}, so what it cuts is unknown."),
    PROVEOUT_TEXT("Core", "Position all axes with G0 before the first cut.")};
inline constexpr FindingRow kIncrementalUnknown{
    Severity::warning,
    true,
    "incremental-from-unknown",
    PROVEOUT_TEXT("Core", "Incremental from unknown position"),
    PROVEOUT_TEXT("Core", "{} moves by an incremental distance from an unknown position."),
    PROVEOUT_TEXT("Core", "Position the axis in G90 first.")};
inline constexpr FindingRow kOneSided{
    Severity::warning,
    true,
    "one-sided-approach",
    PROVEOUT_TEXT("Core", "One-sided positioning"),
    PROVEOUT_TEXT("Core",
                  "G60 overshoots by a distance set in the machine; it is shown without the overshoot."),
    PROVEOUT_TEXT("Core", "Make sure that there is room beyond the target.")};
inline constexpr FindingRow kArcNoCentre{
    Severity::error,
    true,
    "arc-no-centre",
    PROVEOUT_TEXT("Core", "Arc without centre"),
    PROVEOUT_TEXT("Core", "The arc has neither a centre nor a radius."),
    PROVEOUT_TEXT("Core", "Give the centre with {} and {}, or the radius with R.")};
inline constexpr FindingRow kArcCentreIncomplete{
    Severity::error,
    true,
    "arc-centre-incomplete",
    PROVEOUT_TEXT("Core", "Arc centre incomplete"),
    PROVEOUT_TEXT("Core", "An absolute centre (G90.1) needs both {} and {}."),
    PROVEOUT_TEXT("Core", "Add the missing word, or use G91.1.")};
inline constexpr FindingRow kArcMixed{
    Severity::error,
    true,
    "arc-radius-and-centre",
    PROVEOUT_TEXT("Core", "Arc with R and centre"),
    PROVEOUT_TEXT("Core", "The arc has both a centre and a radius."),
    PROVEOUT_TEXT("Core", "Controls differ in which one they use; keep one.")};
inline constexpr FindingRow kArcWrongWord{
    Severity::error,
    true,
    "arc-word-off-plane",
    PROVEOUT_TEXT("Core", "Arc word outside plane"),
    PROVEOUT_TEXT("Core", "The word {} does not belong to an arc in the plane of {}."),
    PROVEOUT_TEXT("Core", "Remove the word, or select the plane that was meant.")};
inline constexpr FindingRow kArcZeroRadius{Severity::error,
                                           true,
                                           "arc-zero-radius",
                                           PROVEOUT_TEXT("Core", "Arc radius zero"),
                                           PROVEOUT_TEXT("Core", "The arc has no radius: {} mm."),
                                           PROVEOUT_TEXT("Core", "The centre is at the start or end point.")};
inline constexpr FindingRow kArcEndsDiffer{
    Severity::error,
    true,
    "arc-ends-differ",
    PROVEOUT_TEXT("Core", "Arc end radius mismatch"),
    PROVEOUT_TEXT("Core", "The arc does not fit: radius {} mm at its start, {} mm at its end, {} mm apart."),
    PROVEOUT_TEXT("Core", "Check the centre: I J K are from the start point, with G90.1 from the origin.")};
inline constexpr FindingRow kArcFullWithRadius{
    Severity::error,
    true,
    "arc-full-with-radius",
    PROVEOUT_TEXT("Core", "Full circle with R"),
    PROVEOUT_TEXT("Core", "An arc with R cannot end where it begins."),
    PROVEOUT_TEXT("Core", "Give a full circle its centre, or make two arcs of it.")};
inline constexpr FindingRow kArcRadiusSmall{
    Severity::error,
    true,
    "arc-radius-small",
    PROVEOUT_TEXT("Core", "Arc radius too small"),
    PROVEOUT_TEXT("Core",
                  "The radius {} mm is too small: the end is {} mm from the start, {} mm more than 2 R."),
    PROVEOUT_TEXT("Core", "Check R and the end point.")};
inline constexpr FindingRow kArcRadiusCounts{
    Severity::warning,
    false,
    "arc-radius-counts",
    PROVEOUT_TEXT("Core", "Arc centre ignored"),
    PROVEOUT_TEXT("Core", "The arc has both a centre and a radius; the radius counts."),
    PROVEOUT_TEXT("Core", "Other controls refuse this; keep one.")};
inline constexpr FindingRow kArcStays{
    Severity::warning,
    false,
    "arc-stays",
    PROVEOUT_TEXT("Core", "Arc without motion"),
    PROVEOUT_TEXT("Core", "The arc with R ends where it begins, so that nothing moves."),
    PROVEOUT_TEXT("Core", "Give a full circle its centre, or make two arcs of it.")};
inline constexpr FindingRow kArcStraight{
    Severity::warning,
    true,
    "arc-straight",
    PROVEOUT_TEXT("Core", "Arc becomes a line"),
    PROVEOUT_TEXT("Core",
                  "The arc has neither a centre nor a radius: the control moves straight, or stops with an "
                  "alarm."),
    PROVEOUT_TEXT("Core", "Give the centre with I, J or K, or the radius with R.")};
inline constexpr FindingRow kArcTooLarge{
    Severity::error,
    true,
    "arc-too-large",
    PROVEOUT_TEXT("Core", "Arc radius too large"),
    PROVEOUT_TEXT("Core", "The radius of the arc is {} mm, beyond what can be computed exactly."),
    PROVEOUT_TEXT("Core", "Check the centre; use G1 for a straight line.")};
inline constexpr FindingRow kArcTooLong{
    Severity::error,
    true,
    "arc-too-long",
    PROVEOUT_TEXT("Core", "Arc too long"),
    PROVEOUT_TEXT("Core", "The path of the arc is {} mm long, beyond the limit of {} mm; it cuts nothing."),
    PROVEOUT_TEXT("Core", "Check the centre and the number of turns.")};
inline constexpr FindingRow kArcTurns{
    Severity::error,
    true,
    "arc-turns",
    PROVEOUT_TEXT("Core", "Invalid number of turns"),
    PROVEOUT_TEXT("Core", "P must be a whole number of turns from 1 to {}."),
    PROVEOUT_TEXT("Core", "Check the P word.")};
inline constexpr FindingRow kArcFromElsewhere{
    Severity::error,
    true,
    "arc-from-elsewhere",
    PROVEOUT_TEXT("Core", "Arc start mismatch"),
    PROVEOUT_TEXT("Core",
                  "The control assumes another tool position than the real one at the start of this arc."),
    PROVEOUT_TEXT("Core", "Program a straight move before the arc; the arc is skipped.")};
inline constexpr FindingRow kArcWordIgnored{
    Severity::warning,
    false,
    "arc-word-ignored",
    PROVEOUT_TEXT("Core", "Arc word ignored"),
    PROVEOUT_TEXT("Core", "The centre word {} is outside the plane of the arc; the control ignores it."),
    PROVEOUT_TEXT("Core", "Remove the word, or select the plane that was meant.")};
inline constexpr FindingRow kArcAxisMissing{
    Severity::error,
    true,
    "arc-axis-missing",
    PROVEOUT_TEXT("Core", "Arc end point missing"),
    PROVEOUT_TEXT("Core", "The arc has no end point in its plane."),
    PROVEOUT_TEXT("Core", "Write the end point, also of a full circle.")};
inline constexpr FindingRow kArcCentreOpen{
    Severity::warning,
    true,
    "arc-centre-open",
    PROVEOUT_TEXT("Core", "Arc centre ambiguous"),
    PROVEOUT_TEXT("Core", "The arc fits with its centre from the start point and also from the origin; a "
                          "setting of the control decides. The start point is assumed."),
    PROVEOUT_TEXT("Core", "Write G91.1 or G90.1 at the beginning of the program.")};
inline constexpr FindingRow kPolarPole{
    Severity::warning,
    true,
    "polar-pole",
    PROVEOUT_TEXT("Core", "Polar centre ambiguous"),
    PROVEOUT_TEXT("Core",
                  "Mach3 uses the tool position as the pole of G16, Mach4 the origin; Mach3 is assumed."),
    PROVEOUT_TEXT("Core", "Begin the polar coordinates where both are the same: at X0 Y0.")};
inline constexpr FindingRow kPolarArc{
    Severity::warning,
    true,
    "polar-arc",
    PROVEOUT_TEXT("Core", "Polar motion undocumented"),
    PROVEOUT_TEXT(
        "Core", "Polar coordinates are for G0 and G1 in the XY plane; their effect on {} is not documented."),
    PROVEOUT_TEXT("Core", "Write G15 before it.")};
inline constexpr FindingRow kRadiusScaled{
    Severity::warning,
    true,
    "radius-scaled",
    PROVEOUT_TEXT("Core", "Radius scaling assumed"),
    PROVEOUT_TEXT("Core", "Whether G51 scales the word {} is not documented; it is assumed to."),
    PROVEOUT_TEXT("Core", "Write G50 before it, or give the centre of an arc by I and J.")};
inline constexpr FindingRow kPlaneXyOnly{
    Severity::error,
    true,
    "plane-xy-only",
    PROVEOUT_TEXT("Core", "XY plane only"),
    PROVEOUT_TEXT("Core", "{} works in the XY plane only."),
    PROVEOUT_TEXT("Core", "Write G17 before it; the code has no effect.")};

inline constexpr std::array kMotionRows{
    &kTargetTooFar,   &kStartUnknown,        &kNeverKnown,     &kIncrementalUnknown, &kOneSided,
    &kArcNoCentre,    &kArcCentreIncomplete, &kArcMixed,       &kArcWrongWord,       &kArcZeroRadius,
    &kArcEndsDiffer,  &kArcFullWithRadius,   &kArcRadiusSmall, &kArcRadiusCounts,    &kArcStays,
    &kArcStraight,    &kArcTooLarge,         &kArcTooLong,     &kArcTurns,           &kArcFromElsewhere,
    &kArcWordIgnored, &kArcAxisMissing,      &kArcCentreOpen,  &kPolarPole,          &kPolarArc,
    &kRadiusScaled,   &kPlaneXyOnly};

} // namespace proveout::nc_message
