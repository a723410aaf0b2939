// SPDX-License-Identifier: GPL-3.0-or-later
// Findings of cutting. Faults with a tool whose sizes are not confirmed have rows of their own, as warnings.
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::cutting_finding {

inline constexpr FindingRow kRapidCuts{
    Severity::fault,
    false,
    "rapid-cuts",
    PROVEOUT_TEXT("Core", "Rapid cuts stock"),
    PROVEOUT_TEXT("Core", "Rapid move cuts stock ({} mm deep)."),
    PROVEOUT_TEXT("Core", "Retract above the stock before the rapid, or cut with G1."),
    SeverityRule::warningIfAssumed};
inline constexpr FindingRow kRapidCutsUnconfirmed{
    Severity::warning,
    true,
    "rapid-cuts",
    PROVEOUT_TEXT("Core", "Rapid cuts stock"),
    PROVEOUT_TEXT("Core", "Rapid move cuts stock ({} mm deep) with the unconfirmed tool T{}."),
    PROVEOUT_TEXT("Core", "Confirm the sizes of the tool in the tool table, or correct them.")};
inline constexpr FindingRow kDepthBeyondFlutes{
    Severity::fault,
    false,
    "depth-beyond-flutes",
    PROVEOUT_TEXT("Core", "Cut beyond flutes"),
    PROVEOUT_TEXT("Core", "The cut is {} mm deep, beyond the length of the flutes."),
    PROVEOUT_TEXT("Core", "Cut in shallower passes, or choose a tool with longer flutes."),
    SeverityRule::warningIfAssumed};
inline constexpr FindingRow kDepthBeyondFlutesUnconfirmed{
    Severity::warning,
    true,
    "depth-beyond-flutes",
    PROVEOUT_TEXT("Core", "Cut beyond flutes"),
    PROVEOUT_TEXT("Core", "The cut is {} mm deep, beyond the flutes of the unconfirmed tool T{}."),
    kRapidCutsUnconfirmed.hint};
inline constexpr FindingRow kNeckInStock{
    Severity::fault,
    false,
    "neck-in-stock",
    PROVEOUT_TEXT("Core", "Neck in stock"),
    PROVEOUT_TEXT("Core", "The neck of the cutter passes through {} mm of stock above its head."),
    PROVEOUT_TEXT("Core", "Cut a slot for the neck first, or choose a tool with a thinner neck."),
    SeverityRule::warningIfAssumed};
inline constexpr FindingRow kNeckInStockUnconfirmed{
    Severity::warning,
    true,
    "neck-in-stock",
    PROVEOUT_TEXT("Core", "Neck in stock"),
    PROVEOUT_TEXT("Core", "{} mm of stock meet the neck of the unconfirmed tool T{}."),
    kRapidCutsUnconfirmed.hint};
inline constexpr FindingRow kHolderCollision{
    Severity::fault,
    false,
    "holder-collision",
    PROVEOUT_TEXT("Core", "Holder collision"),
    PROVEOUT_TEXT("Core", "The holder collides with the stock, {} mm deep at X{} Y{} Z{}."),
    PROVEOUT_TEXT("Core", "Remove the stock there first, or choose a tool with more stick-out."),
    SeverityRule::warningIfAssumed};
inline constexpr FindingRow kHolderCollisionUnconfirmed{
    Severity::warning,
    true,
    "holder-collision",
    PROVEOUT_TEXT("Core", "Holder collision"),
    PROVEOUT_TEXT("Core", "The holder collides with the stock, {} mm deep at X{} Y{} Z{}, with the "
                          "unconfirmed tool T{}."),
    kRapidCutsUnconfirmed.hint};
inline constexpr FindingRow kShankCollision{
    Severity::fault,
    false,
    "shank-collision",
    PROVEOUT_TEXT("Core", "Shank collision"),
    PROVEOUT_TEXT("Core", "The shank collides with the stock, {} mm deep at X{} Y{} Z{}."),
    PROVEOUT_TEXT("Core", "Remove the stock there first, or choose a tool with a thinner shank."),
    SeverityRule::warningIfAssumed};
inline constexpr FindingRow kShankCollisionUnconfirmed{
    Severity::warning,
    true,
    "shank-collision",
    PROVEOUT_TEXT("Core", "Shank collision"),
    PROVEOUT_TEXT("Core", "The shank collides with the stock, {} mm deep at X{} Y{} Z{}, with the "
                          "unconfirmed tool T{}."),
    kRapidCutsUnconfirmed.hint};
inline constexpr FindingRow kCorePlunges{
    Severity::fault,
    false,
    "plunge-not-allowed",
    PROVEOUT_TEXT("Core", "Motion not allowed for tool"),
    PROVEOUT_TEXT("Core", "The tool plunges {} mm deep into material, but is not centre-cutting."),
    PROVEOUT_TEXT("Core", "Drill a hole first, go down on a ramp, or set centre=1 for the tool if it may."),
    SeverityRule::warningIfAssumed};
inline constexpr FindingRow kCorePlungesUnconfirmed{
    Severity::warning,
    true,
    "plunge-not-allowed",
    PROVEOUT_TEXT("Core", "Motion not allowed for tool"),
    PROVEOUT_TEXT("Core", "The plunge goes {} mm deep into material with the unconfirmed tool T{}, which "
                          "is not centre-cutting."),
    kRapidCutsUnconfirmed.hint};
inline constexpr FindingRow kRapidUncheckedStart{
    Severity::error,
    true,
    "rapid-unchecked",
    PROVEOUT_TEXT("Core", "Rapid not checked"),
    PROVEOUT_TEXT("Core", "The rapid move comes from an unknown position and ends {} mm below the top of the "
                          "stock; what it cuts is unknown."),
    PROVEOUT_TEXT("Core", "Retract above the stock before the rapid, or cut with G1.")};
inline constexpr FindingRow kRapidUncheckedHeight{
    Severity::error,
    true,
    "rapid-unchecked",
    PROVEOUT_TEXT("Core", "Rapid not checked"),
    PROVEOUT_TEXT("Core",
                  "The rapid move passes over the stock at an unknown height; whether it cuts is unknown."),
    PROVEOUT_TEXT("Core", "Position Z above the stock before the rapid.")};
inline constexpr FindingRow kOverhangLost{
    Severity::error,
    true,
    "overhang-lost",
    PROVEOUT_TEXT("Core", "Stock above head not shown"),
    PROVEOUT_TEXT("Core", "Above the head of the cutter {} mm³ of stock remain, which the z-map shows as "
                          "removed; the layer is highest at X{} Y{} Z{}."),
    PROVEOUT_TEXT("Core", "Check by other means what is cut there from here on.")};
inline constexpr FindingRow kMoreFindings{
    Severity::note,
    false,
    "more-findings",
    PROVEOUT_TEXT("Core", "More findings"),
    PROVEOUT_TEXT("Core", "{} more findings of the simulation are not shown."),
    "",
    SeverityRule::worstOmitted};

inline constexpr std::array kCuttingRows{
    &kRapidCuts,           &kRapidCutsUnconfirmed,      &kDepthBeyondFlutes, &kDepthBeyondFlutesUnconfirmed,
    &kNeckInStock,         &kNeckInStockUnconfirmed,    &kHolderCollision,   &kHolderCollisionUnconfirmed,
    &kShankCollision,      &kShankCollisionUnconfirmed, &kCorePlunges,       &kCorePlungesUnconfirmed,
    &kRapidUncheckedStart, &kRapidUncheckedHeight,      &kOverhangLost,      &kMoreFindings};

} // namespace proveout::cutting_finding
