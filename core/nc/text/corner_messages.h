// SPDX-License-Identifier: GPL-3.0-or-later
// Chamfers and corner radii between two motions.
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
    PROVEOUT_TEXT("Core",
                  "No straight or circular motion stands on both sides of the chamfer or corner radius "
                  "(alarm 051)."),
    PROVEOUT_TEXT("Core", "Let G1, G2 or G3 in the plane follow; the corner stays sharp.")};
inline constexpr FindingRow kCornerNextBlock{
    Severity::error,
    true,
    "corner-next-block",
    PROVEOUT_TEXT("Core", "Next corner motion missing"),
    PROVEOUT_TEXT("Core",
                  "The block behind the chamfer or corner radius orders neither G1, G2 nor G3 (alarm 052, on "
                  "newer controls 051)."),
    PROVEOUT_TEXT("Core", "Only one dwell in a block of its own may stand between; the corner stays sharp.")};
inline constexpr FindingRow kCornerTwice{
    Severity::error,
    true,
    "corner-twice",
    PROVEOUT_TEXT("Core", "Chamfer and corner radius"),
    PROVEOUT_TEXT("Core", "The block orders a chamfer and a corner radius (alarm 053)."),
    PROVEOUT_TEXT("Core", "Keep one of them; the corner stays sharp.")};
inline constexpr FindingRow kCornerComma{
    Severity::error,
    true,
    "corner-comma",
    PROVEOUT_TEXT("Core", "Invalid comma word"),
    PROVEOUT_TEXT("Core", "Neither C nor R stands behind the comma (alarm 053)."),
    PROVEOUT_TEXT("Core", "Write ,C for a chamfer and ,R for a corner radius.")};
inline constexpr FindingRow kCornerCompensation{
    Severity::error,
    true,
    "corner-compensation",
    PROVEOUT_TEXT("Core", "Corner at compensation change"),
    PROVEOUT_TEXT("Core",
                  "A chamfer or corner radius stands where cutter compensation begins, ends or changes its "
                  "side (alarm 039)."),
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
    PROVEOUT_TEXT("Core",
                  "The manuals do not tell whether G51 scales chamfers and corner radii too; here it does "
                  "not."),
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
    PROVEOUT_TEXT("Core", "A chamfer or corner radius stands between motions in one plane only."),
    PROVEOUT_TEXT("Core", "Move along the third axis in another block; the corner stays sharp.")};
inline constexpr FindingRow kChamferOnArc{
    Severity::warning,
    true,
    "chamfer-on-arc",
    PROVEOUT_TEXT("Core", "Chamfer on arc"),
    PROVEOUT_TEXT("Core",
                  "The manuals do not tell how a chamfer counts along an arc; here it is the straight "
                  "distance from the corner."),
    PROVEOUT_TEXT("Core", "Write the motions out.")};

inline constexpr std::array kCornerRows{
    &kCornerWithoutMotion, &kCornerNextBlock, &kCornerTwice,    &kCornerComma,    &kCornerCompensation,
    &kCornerNegative,      &kCornerScaled,    &kCornerTooLarge, &kCornerOffPlane, &kChamferOnArc};

} // namespace proveout::nc_message
