// SPDX-License-Identifier: GPL-3.0-or-later
// Messages about splines and NURBS.
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::nc_message {

inline constexpr FindingRow kSplinePlane{Severity::error,
                                         true,
                                         "spline-plane",
                                         PROVEOUT_TEXT("Core", "Spline outside XY plane"),
                                         PROVEOUT_TEXT("Core", "{} works in the XY plane only."),
                                         PROVEOUT_TEXT("Core", "Write G17 before it.")};
inline constexpr FindingRow kSplineHandle{
    Severity::error,
    true,
    "spline-handle",
    PROVEOUT_TEXT("Core", "Spline without I and J"),
    PROVEOUT_TEXT("Core", "G5 without I and J continues a G5, but the motion before it is not a G5."),
    PROVEOUT_TEXT("Core", "Program I and J; LinuxCNC would use values left by an earlier block.")};
inline constexpr FindingRow kSplineTooLong{
    Severity::error,
    true,
    "spline-too-long",
    PROVEOUT_TEXT("Core", "Spline too long"),
    PROVEOUT_TEXT("Core", "The spline needs more than {} straight motions."),
    PROVEOUT_TEXT("Core", "Check its points.")};
inline constexpr FindingRow kNurbsAxes{Severity::error,
                                       true,
                                       "nurbs-axes",
                                       PROVEOUT_TEXT("Core", "Control point incomplete"),
                                       PROVEOUT_TEXT("Core", "A control point needs both X and Y."),
                                       PROVEOUT_TEXT("Core", "Add the missing word; the point is ignored.")};
inline constexpr FindingRow kNurbsWeight{
    Severity::error,
    true,
    "nurbs-weight",
    PROVEOUT_TEXT("Core", "Invalid control point weight"),
    PROVEOUT_TEXT("Core", "A control point needs a weight P greater than 0."),
    PROVEOUT_TEXT("Core", "Write P1 for an ordinary point; the point is ignored.")};
inline constexpr FindingRow kNurbsWeightAlone{
    Severity::error,
    true,
    "nurbs-weight-alone",
    PROVEOUT_TEXT("Core", "Weight without control point"),
    PROVEOUT_TEXT("Core", "P without X and Y is the weight of the first control point only."),
    PROVEOUT_TEXT("Core", "Close the NURBS block with G5.3 before the next one begins.")};
inline constexpr FindingRow kNurbsPoints{
    Severity::error,
    true,
    "nurbs-points",
    PROVEOUT_TEXT("Core", "Too few control points"),
    PROVEOUT_TEXT("Core", "The NURBS block has {} control points, fewer than its order {}."),
    PROVEOUT_TEXT("Core", "Add points, or lower the order L.")};
inline constexpr FindingRow kNurbsNotOpen{
    Severity::error,
    true,
    "nurbs-not-open",
    PROVEOUT_TEXT("Core", "NURBS block not open"),
    PROVEOUT_TEXT("Core", "G5.3 closes a NURBS block, but none is open."),
    PROVEOUT_TEXT("Core", "Start it with G5.2; other motions in between end it.")};
inline constexpr FindingRow kNurbsOpen{
    Severity::error,
    true,
    "nurbs-open",
    PROVEOUT_TEXT("Core", "NURBS block not closed"),
    PROVEOUT_TEXT("Core", "A NURBS block was started by G5.2 but not closed: it makes no motion."),
    PROVEOUT_TEXT("Core", "Write G5.3 after its last control point.")};

inline constexpr std::array kSplineRows{&kSplinePlane, &kSplineHandle, &kSplineTooLong,
                                        &kNurbsAxes,   &kNurbsWeight,  &kNurbsWeightAlone,
                                        &kNurbsPoints, &kNurbsNotOpen, &kNurbsOpen};

} // namespace proveout::nc_message
