// SPDX-License-Identifier: GPL-3.0-or-later
// Messages about inputs of the machine, probing and skip motions.
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::nc_message {

inline constexpr FindingRow kInputTwice{
    Severity::error,
    true,
    "input-twice",
    PROVEOUT_TEXT("Core", "M66 with P and E"),
    PROVEOUT_TEXT("Core", "M66 has P and E: a digital and an analog input."),
    PROVEOUT_TEXT("Core", "Keep one of them.")};
inline constexpr FindingRow kInputWait{Severity::error,
                                       true,
                                       "input-wait",
                                       PROVEOUT_TEXT("Core", "M66 wait mode"),
                                       PROVEOUT_TEXT("Core", "M66 cannot wait for an analog input."),
                                       PROVEOUT_TEXT("Core", "Remove L, or write L0.")};
inline constexpr FindingRow kInputAssumed{
    Severity::warning,
    false,
    "input-assumed",
    PROVEOUT_TEXT("Core", "Input value assumed"),
    PROVEOUT_TEXT("Core", "Input value of M66 unknown; #5399 is assumed to be {}."),
    PROVEOUT_TEXT("Core", "What follows is verified as long as it does not read #5399.")};
inline constexpr FindingRow kInputUsed{
    Severity::warning,
    true,
    "input-used",
    PROVEOUT_TEXT("Core", "Input value used"),
    PROVEOUT_TEXT("Core", "This line reads #5399, which holds an input of the machine."),
    PROVEOUT_TEXT("Core", "Results that depend on it are unverified.")};
inline constexpr FindingRow kProbePerRevolution{
    Severity::error,
    true,
    "probe-feed-mode",
    PROVEOUT_TEXT("Core", "Probing with G95"),
    PROVEOUT_TEXT("Core", "Probing with a feed per revolution (G95) is not possible."),
    PROVEOUT_TEXT("Core", "Write G94 and a feed per minute.")};
inline constexpr FindingRow kProbeTooClose{Severity::error,
                                           true,
                                           "probe-too-close",
                                           PROVEOUT_TEXT("Core", "Probing motion too short"),
                                           PROVEOUT_TEXT("Core", "The probing motion ends where it begins."),
                                           PROVEOUT_TEXT("Core", "Check the axis words.")};
inline constexpr FindingRow kSkipAssumed{
    Severity::warning,
    true,
    "skip-assumed",
    PROVEOUT_TEXT("Core", "Skip signal unknown"),
    PROVEOUT_TEXT("Core", "The skip motion is shown to its end; where a signal stops it is unknown."),
    PROVEOUT_TEXT("Core",
                  "#5061 to #5063 hold that end. With a stock and a cutter for its tool it stops at the "
                  "stock.")};
inline constexpr FindingRow kProbeAssumed{
    Severity::warning,
    true,
    "probe-assumed",
    PROVEOUT_TEXT("Core", "Probe contact unknown"),
    PROVEOUT_TEXT("Core", "The position where the probe meets the part is unknown."),
    PROVEOUT_TEXT("Core", "It is assumed to move to its programmed end; #5061 to #5069 hold that, #5070 is "
                          "0. With a stock and a cutter for its tool it stops at the stock.")};
inline constexpr FindingRow kProbeContact{
    Severity::warning,
    false,
    "probe-contact",
    PROVEOUT_TEXT("Core", "Probe contact assumed"),
    PROVEOUT_TEXT("Core",
                  "The probe is assumed to stop at X{} Y{} Z{} mm, where it touches the simulated stock."),
    PROVEOUT_TEXT("Core", "On the machine the part decides; results are verified as long as the program does "
                          "not continue from there or read the result.")};
inline constexpr FindingRow kProbeRelease{
    Severity::warning,
    false,
    "probe-release",
    PROVEOUT_TEXT("Core", "Probe release assumed"),
    PROVEOUT_TEXT("Core",
                  "The probe is assumed to stop at X{} Y{} Z{} mm, where it leaves the simulated stock."),
    PROVEOUT_TEXT("Core", "On the machine the part decides; results are verified as long as the program does "
                          "not continue from there or read the result.")};
inline constexpr FindingRow kProbeUsed{
    Severity::warning,
    true,
    "probe-used",
    PROVEOUT_TEXT("Core", "Probe result used"),
    PROVEOUT_TEXT("Core", "This line uses a probing result, which is assumed from the simulated stock."),
    PROVEOUT_TEXT("Core", "Results are shown for that stop; on another part they are unverified.")};
inline constexpr FindingRow kProbeMissed{
    Severity::error,
    true,
    "probe-missed",
    PROVEOUT_TEXT("Core", "Probe without contact"),
    PROVEOUT_TEXT("Core",
                  "{} reaches its end without touching the simulated stock; the control stops there."),
    PROVEOUT_TEXT("Core", "Check stock, tool and offsets, or probe farther.")};
inline constexpr FindingRow kProbeHeld{
    Severity::error,
    true,
    "probe-held",
    PROVEOUT_TEXT("Core", "Probe still in contact"),
    PROVEOUT_TEXT("Core", "{} reaches its end without leaving the simulated stock; the control stops there."),
    PROVEOUT_TEXT("Core", "Check stock, tool and offsets, or move farther.")};
inline constexpr FindingRow kProbeTouches{
    Severity::error,
    true,
    "probe-touches",
    PROVEOUT_TEXT("Core", "Probe in contact at start"),
    PROVEOUT_TEXT("Core", "{} begins where the probe touches the simulated stock; the control stops there."),
    PROVEOUT_TEXT("Core", "Retract before it; the motion is skipped.")};
inline constexpr FindingRow kProbeFree{
    Severity::error,
    true,
    "probe-free",
    PROVEOUT_TEXT("Core", "Probe free at start"),
    PROVEOUT_TEXT("Core",
                  "{} begins where the probe touches nothing of the simulated stock; the control stops "
                  "there."),
    PROVEOUT_TEXT("Core", "Touch the part before it; the motion is skipped.")};

inline constexpr std::array kProbeRows{&kInputTwice,         &kInputWait,     &kInputAssumed, &kInputUsed,
                                       &kProbePerRevolution, &kProbeTooClose, &kSkipAssumed,  &kProbeAssumed,
                                       &kProbeContact,       &kProbeRelease,  &kProbeUsed,    &kProbeMissed,
                                       &kProbeHeld,          &kProbeTouches,  &kProbeFree};

} // namespace proveout::nc_message
