// SPDX-License-Identifier: GPL-3.0-or-later
// Messages about canned cycles, hole patterns and pockets.
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::nc_message {

inline constexpr FindingRow kCycleWord{
    Severity::error,
    true,
    "cycle-word-missing",
    PROVEOUT_TEXT("Core", "Cycle word missing"),
    PROVEOUT_TEXT("Core", "The cycle {} needs the word {}."),
    PROVEOUT_TEXT("Core", "The first block of a cycle must have it; this one drills nothing.")};
inline constexpr FindingRow kCycleNoAxis{Severity::error,
                                         true,
                                         "cycle-no-axis",
                                         PROVEOUT_TEXT("Core", "Cycle without a position"),
                                         PROVEOUT_TEXT("Core", "The cycle has no axis word."),
                                         PROVEOUT_TEXT("Core", "Program the position of the first hole.")};
inline constexpr FindingRow kCycleInverseTime{
    Severity::error,
    true,
    "cycle-inverse-time",
    PROVEOUT_TEXT("Core", "Cycle with inverse time"),
    PROVEOUT_TEXT("Core", "A cycle cannot be used with inverse time feed."),
    PROVEOUT_TEXT("Core", "Write G94 and a feed before it; the cycle drills nothing.")};
inline constexpr FindingRow kCycleLevels{
    Severity::error,
    true,
    "cycle-levels",
    PROVEOUT_TEXT("Core", "R plane below hole bottom"),
    PROVEOUT_TEXT("Core", "The R plane is below the hole bottom."),
    PROVEOUT_TEXT("Core", "Check R and the depth; the cycle drills nothing.")};
inline constexpr FindingRow kCyclePeck{Severity::error,
                                       true,
                                       "cycle-peck",
                                       PROVEOUT_TEXT("Core", "Invalid peck depth"),
                                       PROVEOUT_TEXT("Core", "The depth of a peck must be greater than 0."),
                                       PROVEOUT_TEXT("Core", "Check the Q word; the cycle drills nothing.")};
inline constexpr FindingRow kPeckMissing{
    Severity::warning,
    false,
    "cycle-peck-missing",
    PROVEOUT_TEXT("Core", "Peck depth missing"),
    PROVEOUT_TEXT("Core", "{} has no Q: the hole is drilled in one go."),
    PROVEOUT_TEXT("Core", "Newer controls stop with an alarm instead; give the depth of a peck.")};
inline constexpr FindingRow kCycleSpindle{
    Severity::error,
    true,
    "cycle-spindle",
    PROVEOUT_TEXT("Core", "Spindle stopped in cycle"),
    PROVEOUT_TEXT("Core", "The spindle must turn for this cycle: {}."),
    PROVEOUT_TEXT("Core", "Switch it on in a block before; the cycle drills nothing.")};
inline constexpr FindingRow kBackBore{
    Severity::warning,
    true,
    "back-bore",
    PROVEOUT_TEXT("Core", "Back boring not verified"),
    PROVEOUT_TEXT("Core", "G87 cuts from below, which a z-map cannot represent."),
    PROVEOUT_TEXT("Core", "The motions are shown; what they cut from below is unverified.")};
inline constexpr FindingRow kBackBoreLevels{
    Severity::error,
    true,
    "back-bore-levels",
    PROVEOUT_TEXT("Core", "Invalid back boring depth"),
    PROVEOUT_TEXT("Core", "Back boring feeds up from R, but the depth is not above R."),
    PROVEOUT_TEXT("Core", "Check R and the depth; the cycle bores nothing.")};
inline constexpr FindingRow kBackBoreReturn{
    Severity::warning,
    false,
    "back-bore-return",
    PROVEOUT_TEXT("Core", "Back boring with G99"),
    PROVEOUT_TEXT("Core", "{} cannot be used with G99; it returns to the initial level."),
    PROVEOUT_TEXT("Core", "Write G98 before it.")};
inline constexpr FindingRow kTapAxesMixed{
    Severity::fault,
    false,
    "tap-axes-mixed",
    PROVEOUT_TEXT("Core", "Tapping feeds off the hole"),
    PROVEOUT_TEXT("Core",
                  "LinuxCNC 2.9 mixes up the axes of a tapping cycle in {}: the tool feeds to another place "
                  "than the hole bottom."),
    PROVEOUT_TEXT("Core", "Tap in G17, or use G33.1.")};
inline constexpr FindingRow kFineBore{
    Severity::warning,
    true,
    "fine-bore",
    PROVEOUT_TEXT("Core", "Fine boring not verified"),
    PROVEOUT_TEXT("Core",
                  "The boring bar moves aside before it leaves the bore, but is cut as a full cylinder."),
    PROVEOUT_TEXT("Core", "Contacts shown during the retract are unverified.")};
inline constexpr FindingRow kManualExit{
    Severity::warning,
    true,
    "manual-exit",
    PROVEOUT_TEXT("Core", "Manual retract"),
    PROVEOUT_TEXT("Core", "The operator retracts the tool from the hole by hand."),
    PROVEOUT_TEXT("Core", "A straight retract is shown; results after this block are unverified.")};
inline constexpr FindingRow kInitialLevelUnknown{
    Severity::warning,
    true,
    "initial-level-unknown",
    PROVEOUT_TEXT("Core", "Initial level unknown"),
    PROVEOUT_TEXT("Core", "G98 returns to the initial level, which is unknown; a return to R is shown."),
    PROVEOUT_TEXT("Core", "Position the axis before the cycle.")};
inline constexpr FindingRow kTapSpindle{
    Severity::warning,
    true,
    "tap-without-spindle",
    PROVEOUT_TEXT("Core", "Tapping with stopped spindle"),
    PROVEOUT_TEXT("Core", "The spindle is stopped and M29 (rigid tapping) is not active."),
    PROVEOUT_TEXT("Core",
                  "Some machines tap rigidly without M29, as shown here; write M29 before the cycle.")};
inline constexpr FindingRow kCycleStoredPlace{
    Severity::warning,
    true,
    "cycle-stored-place",
    PROVEOUT_TEXT("Core", "Cycle only stored"),
    PROVEOUT_TEXT("Core", "With 0 repeats the cycle is only stored; the {} of this block is not moved to."),
    PROVEOUT_TEXT("Core", "Some controls move there; program the position in another block.")};
inline constexpr FindingRow kPatternWithoutCycle{
    Severity::error,
    true,
    "pattern-without-cycle",
    PROVEOUT_TEXT("Core", "Pattern without a cycle"),
    PROVEOUT_TEXT("Core", "{} drills with the active canned cycle, but no cycle is active."),
    PROVEOUT_TEXT("Core", "Write the cycle with L0 in a block before; the pattern drills nothing.")};
inline constexpr FindingRow kBoltLineFirst{
    Severity::warning,
    true,
    "bolt-line-first",
    PROVEOUT_TEXT("Core", "First hole assumed"),
    PROVEOUT_TEXT("Core", "The first hole of G72 is assumed to be at the current position."),
    PROVEOUT_TEXT("Core", "Check it against the manual of the control.")};
inline constexpr FindingRow kPocketWay{
    Severity::warning,
    false,
    "pocket-way",
    PROVEOUT_TEXT("Core", "Pocket path assumed"),
    PROVEOUT_TEXT("Core", "How the control moves from circle to circle of the pocket is not documented; half "
                          "circles are shown."),
    PROVEOUT_TEXT("Core", "The finished pocket is the same.")};
inline constexpr FindingRow kPocketSmall{
    Severity::error,
    true,
    "pocket-small",
    PROVEOUT_TEXT("Core", "Invalid pocket size"),
    PROVEOUT_TEXT("Core", "No pocket leads from radius {} mm to {} mm with a tool of radius {} mm."),
    PROVEOUT_TEXT("Core", "Check I, K and D; the pocket is not milled.")};

inline constexpr std::array kCycleRows{
    &kCycleWord,           &kCycleNoAxis,         &kCycleInverseTime, &kCycleLevels,
    &kCyclePeck,           &kPeckMissing,         &kCycleSpindle,     &kBackBore,
    &kBackBoreLevels,      &kBackBoreReturn,      &kTapAxesMixed,     &kFineBore,
    &kManualExit,          &kInitialLevelUnknown, &kTapSpindle,       &kCycleStoredPlace,
    &kPatternWithoutCycle, &kBoltLineFirst,       &kPocketWay,        &kPocketSmall};

} // namespace proveout::nc_message
