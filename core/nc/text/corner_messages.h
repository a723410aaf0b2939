// SPDX-License-Identifier: GPL-3.0-or-later
// Messages about chamfers and corner radii between two motions.
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::nc_message {

inline constexpr FindingRow kCornerWithoutMotion{
    Severity::error,
    true,
    "corner-without-motion",
    PROVEOUT_TEXT("Core", "Corner without motions"),
    PROVEOUT_TEXT(
        "Core", "The chamfer or corner radius is not between two straight or circular motions (alarm 051)."),
    PROVEOUT_TEXT("Core", "Program G1, G2 or G3 in the plane next; the corner stays sharp.")};
inline constexpr FindingRow kCornerNextBlock{
    Severity::error,
    true,
    "corner-next-block",
    PROVEOUT_TEXT("Core", "Next corner motion missing"),
    PROVEOUT_TEXT("Core", "The block after the chamfer or corner radius has no G1, G2 or G3 (alarm 052, on "
                          "newer controls 051)."),
    PROVEOUT_TEXT("Core",
                  "Only one dwell, in a block of its own, is allowed between them; the corner stays sharp.")};
inline constexpr FindingRow kCornerTwice{
    Severity::error,
    true,
    "corner-twice",
    PROVEOUT_TEXT("Core", "Chamfer and corner radius"),
    PROVEOUT_TEXT("Core", "The block has both a chamfer and a corner radius (alarm 053)."),
    PROVEOUT_TEXT("Core", "Keep one of them; the corner stays sharp.")};
inline constexpr FindingRow kCornerComma{
    Severity::error,
    true,
    "corner-comma",
    PROVEOUT_TEXT("Core", "Invalid comma word"),
    PROVEOUT_TEXT("Core", "Expected C or R after the comma (alarm 053)."),
    PROVEOUT_TEXT("Core", "Write ,C for a chamfer and ,R for a corner radius.")};
inline constexpr FindingRow kCornerCompensation{
    Severity::error,
    true,
    "corner-compensation",
    PROVEOUT_TEXT("Core", "Corner at compensation change"),
    PROVEOUT_TEXT("Core", "A chamfer or corner radius is not allowed where cutter compensation starts, ends "
                          "or changes side (alarm 039)."),
    PROVEOUT_TEXT("Core", "Put it between other motions; the corner stays sharp.")};
inline constexpr FindingRow kCornerNegative{
    Severity::error,
    true,
    "corner-negative",
    PROVEOUT_TEXT("Core", "Negative corner size"),
    PROVEOUT_TEXT("Core", "The chamfer or corner radius of {} mm is negative."),
    PROVEOUT_TEXT("Core", "Write it without a sign; the corner stays sharp.")};
inline constexpr FindingRow kCornerScaled{
    Severity::warning,
    true,
    "corner-scaled",
    PROVEOUT_TEXT("Core", "Corner scaling assumed"),
    PROVEOUT_TEXT(
        "Core",
        "The manuals do not say whether G51 also scales chamfers and corner radii; here it does not."),
    PROVEOUT_TEXT("Core", "Write the motions out.")};
inline constexpr FindingRow kCornerTooLarge{
    Severity::error,
    true,
    "corner-too-large",
    PROVEOUT_TEXT("Core", "Corner too large"),
    PROVEOUT_TEXT("Core",
                  "The chamfer or corner radius of {} mm does not fit between the motions (alarm 055)."),
    PROVEOUT_TEXT("Core", "Use a smaller one; the corner stays sharp.")};
inline constexpr FindingRow kCornerOffPlane{
    Severity::error,
    true,
    "corner-off-plane",
    PROVEOUT_TEXT("Core", "Corner outside plane"),
    PROVEOUT_TEXT("Core", "A chamfer or corner radius needs motions in one plane on both sides."),
    PROVEOUT_TEXT("Core", "Move along the third axis in another block; the corner stays sharp.")};
inline constexpr FindingRow kChamferOnArc{
    Severity::warning,
    true,
    "chamfer-on-arc",
    PROVEOUT_TEXT("Core", "Chamfer on arc"),
    PROVEOUT_TEXT("Core", "The manuals do not say how a chamfer is measured along an arc; here it is the "
                          "straight distance from the corner."),
    PROVEOUT_TEXT("Core", "Write the motions out.")};

inline constexpr std::array kCornerRows{
    &kCornerWithoutMotion, &kCornerNextBlock, &kCornerTwice,    &kCornerComma,    &kCornerCompensation,
    &kCornerNegative,      &kCornerScaled,    &kCornerTooLarge, &kCornerOffPlane, &kChamferOnArc};

} // namespace proveout::nc_message
