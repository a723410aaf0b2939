// SPDX-License-Identifier: GPL-3.0-or-later
// Messages about cutter compensation.
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::nc_message {

inline constexpr FindingRow kCompensationOnAlready{
    Severity::error,
    true,
    "compensation-on-already",
    PROVEOUT_TEXT("Core", "Compensation already active"),
    PROVEOUT_TEXT("Core", "Cutter compensation is on already."),
    PROVEOUT_TEXT("Core", "Write G40 first; {} has no effect.")};
inline constexpr FindingRow kCompensationPlane{
    Severity::error,
    true,
    "compensation-plane",
    PROVEOUT_TEXT("Core", "Compensation plane unsupported"),
    PROVEOUT_TEXT("Core", "Cutter compensation works in the planes of G17 and G18 only."),
    PROVEOUT_TEXT("Core", "Select the plane before; the code has no effect.")};
inline constexpr FindingRow kCompensationTurned{
    Severity::error,
    true,
    "compensation-turned",
    PROVEOUT_TEXT("Core", "Compensation under rotation"),
    PROVEOUT_TEXT("Core", "Cutter compensation in G18 under a rotation about Z is not supported."),
    PROVEOUT_TEXT("Core", "Remove the rotation from the work offset; the code has no effect.")};
inline constexpr FindingRow kCompensationForbids{
    Severity::error,
    true,
    "compensation-forbids",
    PROVEOUT_TEXT("Core", "Not allowed with compensation"),
    PROVEOUT_TEXT("Core", "{} cannot be used while cutter compensation is on."),
    PROVEOUT_TEXT("Core", "Write G40 before it; the code has no effect.")};
inline constexpr FindingRow kCompensationSuspended{
    Severity::warning,
    true,
    "compensation-suspended",
    PROVEOUT_TEXT("Core", "Compensation suspended"),
    PROVEOUT_TEXT("Core", "{} suspends cutter compensation on its way."),
    PROVEOUT_TEXT("Core", "Write G40 before it.")};
inline constexpr FindingRow kCompensationNoDiameter{
    Severity::warning,
    false,
    "compensation-without-diameter",
    PROVEOUT_TEXT("Core", "Compensation diameter 0"),
    PROVEOUT_TEXT("Core", "The diameter for {} is 0, so the tool moves on the programmed path."),
    PROVEOUT_TEXT("Core", "Check the tool table, if the path is not written for the centre of the tool.")};
inline constexpr FindingRow kCompensationDiameterUnknown{
    Severity::warning,
    true,
    "compensation-diameter-unknown",
    PROVEOUT_TEXT("Core", "Compensation diameter unknown"),
    PROVEOUT_TEXT("Core", "No diameter is known for {}, so the tool moves on the programmed path."),
    PROVEOUT_TEXT("Core", "Give the tools of the program.")};
inline constexpr FindingRow kCompensationUnknownStart{
    Severity::error,
    true,
    "compensation-from-unknown",
    PROVEOUT_TEXT("Core", "Compensation from unknown position"),
    PROVEOUT_TEXT("Core", "The motion is not compensated: it leads from or to a place that is not known."),
    PROVEOUT_TEXT("Core", "Position the axes of the plane before G41 or G42.")};
inline constexpr FindingRow kCompensationEntryShort{
    Severity::error,
    true,
    "compensation-entry-short",
    PROVEOUT_TEXT("Core", "Lead-in too short"),
    PROVEOUT_TEXT("Core", "The motion into cutter compensation is {} mm long, not longer than the tool's "
                          "radius of {} mm."),
    PROVEOUT_TEXT("Core", "Begin farther away; the motion is skipped."),
    SeverityRule::warningIfAssumed};
inline constexpr FindingRow kCompensationArcSmall{
    Severity::error,
    true,
    "compensation-arc-small",
    PROVEOUT_TEXT("Core", "Arc smaller than tool"),
    PROVEOUT_TEXT("Core", "The arc has a radius of {} mm, not larger than the tool's radius of {} mm."),
    PROVEOUT_TEXT("Core", "Use a smaller tool; the motion is skipped."),
    SeverityRule::warningIfAssumed};
inline constexpr FindingRow kCompensationCorner{
    Severity::error,
    true,
    "compensation-corner",
    PROVEOUT_TEXT("Core", "Inside corner too tight"),
    PROVEOUT_TEXT("Core", "The tool with a radius of {} mm does not fit into this inside corner."),
    PROVEOUT_TEXT("Core", "Use a smaller tool; the motion is skipped."),
    SeverityRule::warningIfAssumed};
inline constexpr FindingRow kCompensationGouge{
    Severity::error,
    true,
    "compensation-gouge",
    PROVEOUT_TEXT("Core", "Compensation gouge"),
    PROVEOUT_TEXT("Core", "The tool with a radius of {} mm gouges between the inside corners of the motion "
                          "of line {}."),
    PROVEOUT_TEXT("Core", "Use a smaller tool, or remove the short motion."),
    SeverityRule::warningIfAssumed};
inline constexpr FindingRow kCompensationBackward{
    Severity::warning,
    false,
    "compensation-backward",
    PROVEOUT_TEXT("Core", "Compensated motion reversed"),
    PROVEOUT_TEXT("Core",
                  "The tool with a radius of {} mm goes backward in the motion of line {} and gouges; "
                  "LinuxCNC does not notice."),
    PROVEOUT_TEXT("Core", "Use a smaller tool, or remove the short motion."),
    SeverityRule::warningIfAssumed};
inline constexpr FindingRow kCompensationAfterStop{
    Severity::warning,
    true,
    "compensation-after-stop",
    PROVEOUT_TEXT("Core", "Stop before inside corner"),
    PROVEOUT_TEXT("Core", "A stop before this inside corner makes the tool overrun it and gouge."),
    PROVEOUT_TEXT("Core", "Stop elsewhere: the corner is known only when the motion to it is done.")};
inline constexpr FindingRow kCompensationExitArc{
    Severity::error,
    true,
    "compensation-exit-arc",
    PROVEOUT_TEXT("Core", "Lead-out on arc"),
    PROVEOUT_TEXT("Core", "The first motion after G40 must be straight."),
    PROVEOUT_TEXT("Core", "Lead out with G0 or G1; the arc is skipped.")};
inline constexpr FindingRow kCompensationStartArc{
    Severity::error,
    true,
    "compensation-start-arc",
    PROVEOUT_TEXT("Core", "Lead-in on arc"),
    PROVEOUT_TEXT("Core", "Cutter compensation cannot begin on an arc (alarm 034)."),
    PROVEOUT_TEXT("Core", "Lead in with G0 or G1; the arc is skipped."),
    SeverityRule::warningIfAssumed};
inline constexpr FindingRow kCompensationSquare{
    Severity::warning,
    false,
    "compensation-square",
    PROVEOUT_TEXT("Core", "Corner not compensated"),
    PROVEOUT_TEXT("Core", "The corner before this motion is not compensated: the tool stops square to the "
                          "end of the block before it, and continues from there."),
    PROVEOUT_TEXT("Core", "Keep stops, repeated codes and blocks without a motion away from corners.")};
inline constexpr FindingRow kCompensationSideApart{
    Severity::warning,
    true,
    "compensation-side-apart",
    PROVEOUT_TEXT("Core", "Compensation side change"),
    PROVEOUT_TEXT("Core", "The tool changes side between paths that do not meet."),
    PROVEOUT_TEXT("Core", "Write G40 before the other side.")};
inline constexpr FindingRow kCompensationErased{
    Severity::error,
    true,
    "compensation-erased",
    PROVEOUT_TEXT("Core", "Compensation points dropped"),
    PROVEOUT_TEXT("Core",
                  "The tool with a radius of {} mm goes backward in the motion of line {}; the control "
                  "leaves out points of the corner before it, or stops (alarm 041)."),
    PROVEOUT_TEXT("Core", "Use a smaller tool, or remove the short motion."),
    SeverityRule::warningIfAssumed};
inline constexpr FindingRow kCompensationOffCircle{
    Severity::warning,
    true,
    "compensation-off-circle",
    PROVEOUT_TEXT("Core", "Compensated arc off circle"),
    PROVEOUT_TEXT("Core", "The compensated arc begins {} mm off its circle."),
    PROVEOUT_TEXT("Core", "Change side, radius or code of compensation before a straight motion.")};
inline constexpr FindingRow kCompensationAtEnd{
    Severity::warning,
    false,
    "compensation-at-end",
    PROVEOUT_TEXT("Core", "Compensation active at end"),
    PROVEOUT_TEXT("Core", "Cutter compensation is still on at the end of the program."),
    PROVEOUT_TEXT("Core", "Lead out with G40.")};

inline constexpr std::array kCompensationRows{
    &kCompensationOnAlready,       &kCompensationPlane,        &kCompensationTurned,
    &kCompensationForbids,         &kCompensationSuspended,    &kCompensationNoDiameter,
    &kCompensationDiameterUnknown, &kCompensationUnknownStart, &kCompensationEntryShort,
    &kCompensationArcSmall,        &kCompensationCorner,       &kCompensationGouge,
    &kCompensationBackward,        &kCompensationAfterStop,    &kCompensationExitArc,
    &kCompensationStartArc,        &kCompensationSquare,       &kCompensationSideApart,
    &kCompensationErased,          &kCompensationOffCircle,    &kCompensationAtEnd};

} // namespace proveout::nc_message
