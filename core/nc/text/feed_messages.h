// SPDX-License-Identifier: GPL-3.0-or-later
// Messages about feed, spindle and coolant.
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::nc_message {

inline constexpr FindingRow kInverseTimeFeed{
    Severity::error,
    true,
    "inverse-time-feed",
    PROVEOUT_TEXT("Core", "F missing with G93"),
    PROVEOUT_TEXT("Core", "With inverse time feed (G93) every cutting block needs an F word."),
    PROVEOUT_TEXT("Core", "Add F, one over the minutes that the motion takes.")};
inline constexpr FindingRow kFeedWithoutSpindle{
    Severity::error,
    true,
    "feed-without-spindle",
    PROVEOUT_TEXT("Core", "Feed per revolution without spindle"),
    PROVEOUT_TEXT("Core", "The feed counts per revolution (G95), but the spindle does not turn."),
    PROVEOUT_TEXT("Core", "Switch the spindle on, or write G94 and a feed per minute.")};
inline constexpr FindingRow kFeedInOldUnit{
    Severity::warning,
    false,
    "feed-before-units",
    PROVEOUT_TEXT("Core", "Feed before unit change"),
    PROVEOUT_TEXT("Core", "The feed is read in the unit that was in force before {}."),
    PROVEOUT_TEXT("Core", "LinuxCNC reads F first; switch the unit in a block before.")};
inline constexpr FindingRow kDiameterMode{
    Severity::error,
    true,
    "diameter-mode",
    PROVEOUT_TEXT("Core", "Diameter mode"),
    PROVEOUT_TEXT("Core", "G7 makes X a diameter, as on a lathe: LinuxCNC would halve every X."),
    PROVEOUT_TEXT("Core", "Remove it, or write G8; X is shown as a radius.")};
inline constexpr FindingRow kSurfaceSpeedLimited{
    Severity::warning,
    false,
    "surface-speed-limited",
    PROVEOUT_TEXT("Core", "Surface speed at limit"),
    PROVEOUT_TEXT("Core", "With G96 the spindle follows X; it is taken to turn at its limit D, {} rpm."),
    PROVEOUT_TEXT("Core", "X is not a diameter on a mill: write G97 and a speed.")};
inline constexpr FindingRow kSurfaceSpeedUnknown{
    Severity::warning,
    false,
    "surface-speed-unknown",
    PROVEOUT_TEXT("Core", "Spindle speed unknown"),
    PROVEOUT_TEXT("Core", "Spindle speed is unknown, because G96 has no D."),
    PROVEOUT_TEXT("Core", "Write G97 and a speed, or a limit D.")};
inline constexpr FindingRow kPitch{Severity::error,
                                   true,
                                   "pitch",
                                   PROVEOUT_TEXT("Core", "Invalid pitch"),
                                   PROVEOUT_TEXT("Core", "The pitch K must be greater than 0."),
                                   PROVEOUT_TEXT("Core", "Check the K word; nothing moves.")};
inline constexpr FindingRow kSynchronisedFeed{
    Severity::error,
    true,
    "synchronised-feed",
    PROVEOUT_TEXT("Core", "F with synchronised motion"),
    PROVEOUT_TEXT("Core", "{} moves in step with the spindle and takes no F."),
    PROVEOUT_TEXT("Core", "Remove F; the feed is the pitch K times the speed of the spindle.")};
inline constexpr FindingRow kSynchronisedSpindle{
    Severity::error,
    true,
    "synchronised-spindle",
    PROVEOUT_TEXT("Core", "Synchronised motion, spindle stopped"),
    PROVEOUT_TEXT("Core", "{} moves in step with the spindle, which does not turn."),
    PROVEOUT_TEXT("Core", "Write S and M3 or M4 in a block before.")};
inline constexpr FindingRow kNoFeed{
    Severity::error,
    true,
    "feed-missing",
    PROVEOUT_TEXT("Core", "Feed rate missing"),
    PROVEOUT_TEXT("Core", "A cutting motion has no feed rate."),
    PROVEOUT_TEXT("Core", "Give F in this block or before it; there is no default.")};
inline constexpr FindingRow kMistOption{
    Severity::warning,
    true,
    "mist-option",
    PROVEOUT_TEXT("Core", "Mist coolant optional"),
    PROVEOUT_TEXT("Core", "M7 is known only where grbl was built with mist coolant."),
    PROVEOUT_TEXT("Core",
                  "Otherwise grbl reports error:20 and skips the block; give M7 a block of its own.")};
inline constexpr FindingRow kDwellUnit{
    Severity::warning,
    false,
    "dwell-unit",
    PROVEOUT_TEXT("Core", "Dwell unit ambiguous"),
    PROVEOUT_TEXT("Core", "A setting of the control decides whether the dwell of {} is {} s or {} s; it is "
                          "taken as the first."),
    PROVEOUT_TEXT("Core", "Check on the control whether P counts seconds or milliseconds.")};

inline constexpr std::array kFeedRows{&kInverseTimeFeed, &kFeedWithoutSpindle,  &kFeedInOldUnit,
                                      &kDiameterMode,    &kSurfaceSpeedLimited, &kSurfaceSpeedUnknown,
                                      &kPitch,           &kSynchronisedFeed,    &kSynchronisedSpindle,
                                      &kNoFeed,          &kMistOption,          &kDwellUnit};

} // namespace proveout::nc_message
