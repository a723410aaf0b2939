// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of a setup that are asked for: one description each, read by the job file, the command line and
// the setup panel.
#pragma once

#include "core/base/field.h"
#include "core/base/text.h"
#include "core/base/tool_number.h"

namespace proveout::setup_field {

inline constexpr double kFarthest = 1e7; ///< mm; positions lie within ± that

inline constexpr Field kMinX{
    "minX",     PROVEOUT_TEXT("Core", "Min X"),
    "mm",       PROVEOUT_TEXT("Core", "Program coordinate of the left side of the stock."),
    -kFarthest, kFarthest,
    1};
inline constexpr Field kMinY{
    "minY",     PROVEOUT_TEXT("Core", "Min Y"),
    "mm",       PROVEOUT_TEXT("Core", "Program coordinate of the front side of the stock."),
    -kFarthest, kFarthest,
    1};
inline constexpr Field kTopZ{"topZ",     PROVEOUT_TEXT("Core", "Top Z"),
                             "mm",       PROVEOUT_TEXT("Core", "Program coordinate of the top of the stock."),
                             -kFarthest, kFarthest,
                             1};
inline constexpr Field kGrid{"grid",
                             PROVEOUT_TEXT("Core", "Grid spacing"),
                             "mm",
                             PROVEOUT_TEXT("Core", "Distance between the points of the z-map; adjusted so "
                                                   "that it divides the stock exactly."),
                             0.001,
                             1000,
                             0.1};
inline constexpr Field kStart{"start",
                              PROVEOUT_TEXT("Core", "Start position"),
                              "mm",
                              PROVEOUT_TEXT("Core", "Program coordinates of the tool tip before the first "
                                                    "block; unknown if not set."),
                              -kFarthest,
                              kFarthest,
                              1};
inline constexpr Field kStartTool{"startTool",
                                  PROVEOUT_TEXT("Core", "Tool at start"),
                                  "",
                                  PROVEOUT_TEXT("Core", "Tool in the spindle before the first tool change; 0 "
                                                        "is an empty spindle, or T0 of the tool table."),
                                  kLeastTool,
                                  kLargestTool,
                                  1};

} // namespace proveout::setup_field
