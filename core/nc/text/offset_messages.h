// SPDX-License-Identifier: GPL-3.0-or-later
// Messages about offsets, transformations, reference positions and machine coordinates.
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::nc_message {

inline constexpr FindingRow kLengthTwice{
    Severity::error,
    true,
    "length-twice",
    PROVEOUT_TEXT("Core", "G43.2 with H and axes"),
    PROVEOUT_TEXT("Core", "G43.2 has both H and axis words."),
    PROVEOUT_TEXT("Core", "Write two blocks; the offset in force is kept.")};
inline constexpr FindingRow kOffsetKind{Severity::error,
                                        true,
                                        "offset-kind",
                                        PROVEOUT_TEXT("Core", "Unsupported G10"),
                                        PROVEOUT_TEXT("Core", "G10 with L{} is not supported."),
                                        PROVEOUT_TEXT("Core", "Supported are L1, L2, L10, L11 and L20.")};
inline constexpr FindingRow kOffsetUnknown{
    Severity::error,
    true,
    "offset-unknown",
    PROVEOUT_TEXT("Core", "Tool number unknown"),
    PROVEOUT_TEXT("Core", "No tool has the number {}."),
    PROVEOUT_TEXT("Core", "Add it to the tool table, or correct the number.")};
inline constexpr FindingRow kMachineMotion{
    Severity::error,
    true,
    "machine-coordinates-motion",
    PROVEOUT_TEXT("Core", "G53 without G0 or G1"),
    PROVEOUT_TEXT("Core", "G53 needs G0 or G1 in force."),
    PROVEOUT_TEXT("Core", "Write G53 G0 or G53 G1; this block is skipped.")};
inline constexpr FindingRow kPolarMixed{Severity::error,
                                        true,
                                        "polar-mixed",
                                        PROVEOUT_TEXT("Core", "Polar and Cartesian words"),
                                        PROVEOUT_TEXT("Core", "The block has polar words (@ ^) and X or Y."),
                                        PROVEOUT_TEXT("Core", "Keep one kind; this block is skipped.")};
inline constexpr FindingRow kPolarOrigin{
    Severity::error,
    true,
    "polar-origin",
    PROVEOUT_TEXT("Core", "Polar angle undefined"),
    PROVEOUT_TEXT("Core", "{} counts from the current angle, and there is no angle at X0 Y0."),
    PROVEOUT_TEXT("Core", "Give both @ and ^ in G90; this motion is skipped.")};
inline constexpr FindingRow kMachinePolar{Severity::error,
                                          true,
                                          "machine-coordinates-polar",
                                          PROVEOUT_TEXT("Core", "G53 with polar words"),
                                          PROVEOUT_TEXT("Core", "G53 cannot be used with polar words."),
                                          PROVEOUT_TEXT("Core", "Write X and Y; this block is skipped.")};
inline constexpr FindingRow kMachineIncremental{
    Severity::error,
    true,
    "machine-coordinates-incremental",
    PROVEOUT_TEXT("Core", "G53 in incremental mode"),
    PROVEOUT_TEXT("Core", "G53 cannot be used with incremental distances."),
    PROVEOUT_TEXT("Core", "Write G90 before it; this block is skipped.")};
inline constexpr FindingRow kMachineIgnored{
    Severity::warning,
    true,
    "machine-coordinates-ignored",
    PROVEOUT_TEXT("Core", "G53 ignored"),
    PROVEOUT_TEXT("Core", "G53 is ignored with incremental distances; nothing moves."),
    PROVEOUT_TEXT("Core", "Write G90 before it.")};
inline constexpr FindingRow kReferenceUnknown{
    Severity::note,
    false,
    "reference-unknown",
    PROVEOUT_TEXT("Core", "Machine zero unknown"),
    PROVEOUT_TEXT("Core", "Machine zero is unknown, so {} has no position; motions are not simulated until "
                          "the axis is positioned again."),
    PROVEOUT_TEXT("Core", "Motions to reference positions are taken to lead away from the part.")};
inline constexpr FindingRow kArcTurned{
    Severity::error,
    true,
    "arc-turned",
    PROVEOUT_TEXT("Core", "Arc outside rotated plane"),
    PROVEOUT_TEXT(
        "Core",
        "G68 rotates in another plane than that of the arc, which then is in no plane of the machine."),
    PROVEOUT_TEXT("Core", "Keep the plane that was active at G68.")};
inline constexpr FindingRow kArcScaled{
    Severity::error,
    true,
    "arc-scaled",
    PROVEOUT_TEXT("Core", "Arc scaled unevenly"),
    PROVEOUT_TEXT("Core",
                  "Different scale factors along the axes of its plane turn this arc into an ellipse."),
    PROVEOUT_TEXT("Core", "Use one factor for both axes, or let the CAM system output lines.")};
inline constexpr FindingRow kScaleFactor{Severity::error,
                                         true,
                                         "scale-factor",
                                         PROVEOUT_TEXT("Core", "Scale factor 0"),
                                         PROVEOUT_TEXT("Core", "The scale factor of {} must not be 0."),
                                         PROVEOUT_TEXT("Core", "Check the number; the code has no effect.")};
inline constexpr FindingRow kTransformationOrder{
    Severity::warning,
    true,
    "transformation-order",
    PROVEOUT_TEXT("Core", "Transformation order"),
    PROVEOUT_TEXT("Core", "{} is inside {}: the control needs mirror image, scaling and rotation started in "
                          "this order and cancelled in the opposite one."),
    PROVEOUT_TEXT("Core", "Cancel the inner one first.")};
inline constexpr FindingRow kCentreUnknown{
    Severity::warning,
    true,
    "centre-unknown",
    PROVEOUT_TEXT("Core", "Transformation centre unknown"),
    PROVEOUT_TEXT("Core", "The centre of {} is the current position, which is unknown for {}."),
    PROVEOUT_TEXT("Core", "Program the centre, or position the tool first.")};
inline constexpr FindingRow kRotationOneAxis{
    Severity::warning,
    true,
    "rotation-one-axis",
    PROVEOUT_TEXT("Core", "Rotation start ambiguous"),
    PROVEOUT_TEXT(
        "Core",
        "The first motion after {} does not program both axes of the rotation; controls differ here."),
    PROVEOUT_TEXT("Core", "Position both axes in G90 after it.")};
inline constexpr FindingRow kRotationSetting{
    Severity::warning,
    true,
    "rotation-setting",
    PROVEOUT_TEXT("Core", "Rotation angle ambiguous"),
    PROVEOUT_TEXT("Core",
                  "A setting of the control decides whether G68 with G91 adds its angle to the active one "
                  "(Fanuc: parameter 5400#0, Haas: setting 73); here the angle is {} degrees."),
    PROVEOUT_TEXT("Core", "Write G90 before G68, or G69 between them.")};
inline constexpr FindingRow kReferenceInCycle{
    Severity::error,
    true,
    "reference-in-cycle",
    PROVEOUT_TEXT("Core", "Reference return in cycle"),
    PROVEOUT_TEXT("Core", "{} is not allowed while a canned cycle is active (alarm 044)."),
    PROVEOUT_TEXT("Core", "End the cycle with G80 before it.")};
inline constexpr FindingRow kNoIntermediate{
    Severity::error,
    true,
    "intermediate-unknown",
    PROVEOUT_TEXT("Core", "Intermediate point unknown"),
    PROVEOUT_TEXT("Core", "G29 returns through the intermediate point of G28, which is unknown for {}."),
    PROVEOUT_TEXT("Core", "Position the axis before G28 and program it there.")};
inline constexpr FindingRow kAxesReferenced{
    Severity::warning,
    true,
    "axes-referenced",
    PROVEOUT_TEXT("Core", "Homing cycle"),
    PROVEOUT_TEXT("Core", "{} seeks the reference switches; the axis positions afterwards are unknown."),
    PROVEOUT_TEXT("Core", "Position the axes before the next cut.")};
inline constexpr FindingRow kDataKind{Severity::error,
                                      true,
                                      "data-kind",
                                      PROVEOUT_TEXT("Core", "Unsupported G10"),
                                      PROVEOUT_TEXT("Core", "G10 with L{} is not supported."),
                                      PROVEOUT_TEXT("Core", "Supported are L1, L2, L10 to L13 and L20.")};
inline constexpr FindingRow kDataSkipped{
    Severity::warning,
    true,
    "data-skipped",
    PROVEOUT_TEXT("Core", "Control data skipped"),
    PROVEOUT_TEXT("Core",
                  "G10 with L{} begins to set data of the control; the blocks up to G11 are skipped."),
    PROVEOUT_TEXT("Core", "What depends on these data is unverified.")};
inline constexpr FindingRow kRegisterUnknown{
    Severity::error,
    true,
    "register-unknown",
    PROVEOUT_TEXT("Core", "Offset register unknown"),
    PROVEOUT_TEXT("Core", "The offset register {} is not known."),
    PROVEOUT_TEXT("Core", "The tool with its number fills it, or G10; add the tool, or correct the number.")};
inline constexpr FindingRow kLengthWithoutAxis{
    Severity::warning,
    true,
    "length-without-axis",
    PROVEOUT_TEXT("Core", "Length offset without Z"),
    PROVEOUT_TEXT(
        "Core",
        "{} changes the tool length without a Z word; some machines move by the difference, others do not."),
    PROVEOUT_TEXT("Core", "Position Z in the same block; here Z does not move.")};
inline constexpr FindingRow kShiftNotTurned{
    Severity::fault,
    false,
    "shift-not-turned",
    PROVEOUT_TEXT("Core", "Rotation with G92 active"),
    PROVEOUT_TEXT("Core", "{} rotates the work offset while G92 or G52 is active: LinuxCNC then assumes a "
                          "wrong tool position."),
    PROVEOUT_TEXT("Core", "Cancel the shift with G92.1 first, and set it again afterwards.")};

inline constexpr std::array kOffsetRows{
    &kLengthTwice,     &kOffsetKind,      &kOffsetUnknown,      &kMachineMotion,       &kPolarMixed,
    &kPolarOrigin,     &kMachinePolar,    &kMachineIncremental, &kMachineIgnored,      &kReferenceUnknown,
    &kArcTurned,       &kArcScaled,       &kScaleFactor,        &kTransformationOrder, &kCentreUnknown,
    &kRotationOneAxis, &kRotationSetting, &kReferenceInCycle,   &kNoIntermediate,      &kAxesReferenced,
    &kDataKind,        &kDataSkipped,     &kRegisterUnknown,    &kLengthWithoutAxis,   &kShiftNotTurned};

} // namespace proveout::nc_message
