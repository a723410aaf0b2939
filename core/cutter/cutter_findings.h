// SPDX-License-Identifier: GPL-3.0-or-later
// Findings about cutters: their specifications and the profiles made from them.
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::cutter_finding {

inline constexpr FindingRow kFormNoWidth{Severity::error,
                                         false,
                                         "form-no-width",
                                         PROVEOUT_TEXT("Core", "Profile without width"),
                                         PROVEOUT_TEXT("Core", "The profile at character {} has no width."),
                                         ""};
inline constexpr FindingRow kFormTooLong{
    Severity::error,
    false,
    "form-too-long",
    PROVEOUT_TEXT("Core", "Too many profile points"),
    PROVEOUT_TEXT("Core", "The profile continues at character {} after {} points; it may have no more."),
    ""};
inline constexpr FindingRow kFormTurnsBack{
    Severity::error,
    false,
    "form-turns-back",
    PROVEOUT_TEXT("Core", "Profile turns back"),
    PROVEOUT_TEXT("Core", "At character {} the profile turns back towards the axis."),
    ""};
inline constexpr FindingRow kFormUnreadable{
    Severity::error,
    false,
    "form-unreadable",
    PROVEOUT_TEXT("Core", "Invalid profile point"),
    PROVEOUT_TEXT(
        "Core",
        "At character {}, “{}” is not a profile point; a point is written as {}, an arc to it as {} or {}."),
    ""};
inline constexpr FindingRow kFormFalls{
    Severity::error,
    false,
    "form-falls",
    PROVEOUT_TEXT("Core", "Profile falls"),
    PROVEOUT_TEXT("Core",
                  "At character {} the profile falls; from the axis outwards it may only rise or stay."),
    ""};
inline constexpr FindingRow kFormStart{
    Severity::error,
    false,
    "form-start",
    PROVEOUT_TEXT("Core", "Profile not at the tip"),
    PROVEOUT_TEXT("Core", "At character {} the profile begins with “{}”, not at the tip, {}."),
    ""};
inline constexpr FindingRow kFormArcRadius{
    Severity::error,
    false,
    "form-arc-radius",
    PROVEOUT_TEXT("Core", "Profile arc radius too small"),
    PROVEOUT_TEXT("Core", "The arc at character {} has the radius {} mm, too small for ends {} mm apart."),
    ""};
inline constexpr FindingRow kFormArcCentre{
    Severity::error,
    false,
    "form-arc-centre",
    PROVEOUT_TEXT("Core", "Profile arc centre mismatch"),
    PROVEOUT_TEXT("Core", "The arc at character {} has ends that are {} mm and {} mm away from its centre."),
    ""};
inline constexpr FindingRow kFormArcTurns{
    Severity::error,
    false,
    "form-arc-turns",
    PROVEOUT_TEXT("Core", "Profile arc turns back"),
    PROVEOUT_TEXT("Core", "The arc at character {} falls or turns back towards the axis; it may be a quarter "
                          "of a circle at most, from level to upright."),
    ""};
inline constexpr FindingRow kFormNoTip{
    Severity::error,
    false,
    "form-no-tip",
    PROVEOUT_TEXT("Core", "Profile tip without width"),
    PROVEOUT_TEXT("Core", "Before character {} the profile rises on the axis itself; its tip has no width."),
    ""};
inline constexpr FindingRow kFormTooFine{
    Severity::error,
    false,
    "form-too-fine",
    PROVEOUT_TEXT("Core", "Profile arcs too large"),
    PROVEOUT_TEXT("Core", "The arcs up to character {} are so large that they take more than {} lines."),
    ""};
inline constexpr FindingRow kTipTooLarge{
    Severity::error,
    false,
    "tip-too-large",
    PROVEOUT_TEXT("Core", "Tip too large"),
    PROVEOUT_TEXT("Core", "The flat tip tip={} is not smaller than the diameter, {} mm."),
    ""};
inline constexpr FindingRow kPilotTooLarge{
    Severity::error,
    false,
    "pilot-too-large",
    PROVEOUT_TEXT("Core", "Pilot too large"),
    PROVEOUT_TEXT("Core", "The pilot, pilot={}, is not smaller than the diameter, {} mm."),
    ""};
inline constexpr FindingRow kPilotTooShort{
    Severity::error,
    false,
    "pilot-too-short",
    PROVEOUT_TEXT("Core", "Pilot too short"),
    PROVEOUT_TEXT("Core", "The pilot, pl={}, is shorter than its point, {} mm."),
    ""};
inline constexpr FindingRow kLeadTooLong{
    Severity::error,
    false,
    "lead-too-long",
    PROVEOUT_TEXT("Core", "Lead too long"),
    PROVEOUT_TEXT("Core", "The lead, lead={}, ends in a point; {} mm is the longest."),
    ""};
inline constexpr FindingRow kCornerRadiusTooLarge{
    Severity::error,
    false,
    "corner-radius-too-large",
    PROVEOUT_TEXT("Core", "Corner radius too large"),
    PROVEOUT_TEXT("Core", "The corner radius r={} is larger than half the diameter, {} mm."),
    ""};
inline constexpr FindingRow kCornerRadiusTooLargeFit{
    Severity::error,
    false,
    "corner-radius-too-large",
    PROVEOUT_TEXT("Core", "Corner radius too large"),
    PROVEOUT_TEXT("Core", "The corner radius r={} does not fit; {} mm is the largest."),
    ""};
inline constexpr FindingRow kTaperTooLow{
    Severity::error,
    false,
    "taper-too-low",
    PROVEOUT_TEXT("Core", "Taper too low"),
    PROVEOUT_TEXT("Core", "The height h={} is not more than that of the rounded tip, {} mm."),
    ""};
inline constexpr FindingRow kNeckTooThick{
    Severity::error,
    false,
    "neck-too-thick",
    PROVEOUT_TEXT("Core", "Neck too thick"),
    PROVEOUT_TEXT("Core", "The neck, neck={}, must be thinner than {} mm, the head at its top."),
    ""};
inline constexpr FindingRow kHeadTooHigh{
    Severity::error,
    false,
    "head-too-high",
    PROVEOUT_TEXT("Core", "Head too high"),
    PROVEOUT_TEXT("Core", "With h={} the flanks meet below the top; {} mm is the limit."),
    ""};
inline constexpr FindingRow kCutterValueNotANumber{
    Severity::error,
    false,
    "cutter-value-not-a-number",
    PROVEOUT_TEXT("Core", "Cutter value not numeric"),
    PROVEOUT_TEXT("Core", "The value of {}, “{}”, is not a number."),
    ""};
inline constexpr FindingRow kCutterValueOutOfRange{
    Severity::error,
    false,
    "cutter-value-out-of-range",
    PROVEOUT_TEXT("Core", "Cutter value out of range"),
    PROVEOUT_TEXT("Core", "{}={} is out of range, {} to {} {}."),
    ""};
inline constexpr FindingRow kCutterValueNotWhole{
    Severity::error,
    false,
    "cutter-value-not-a-number",
    kCutterValueNotANumber.title,
    PROVEOUT_TEXT("Core", "The value of {}, “{}”, is not a whole number."),
    ""};
inline constexpr FindingRow kCutterKeyTwice{Severity::error,
                                            false,
                                            "cutter-key-twice",
                                            PROVEOUT_TEXT("Core", "Duplicate cutter key"),
                                            PROVEOUT_TEXT("Core", "The key {} is specified twice."),
                                            ""};
inline constexpr FindingRow kCutterKeyUnknown{
    Severity::error,
    false,
    "cutter-key-unknown",
    PROVEOUT_TEXT("Core", "Unknown cutter key"),
    PROVEOUT_TEXT("Core", "“{}” is not a key of this cutter shape; there are {}."),
    ""};
inline constexpr FindingRow kCutterKeyMissing{
    Severity::error,
    false,
    "cutter-key-missing",
    PROVEOUT_TEXT("Core", "Cutter key missing"),
    PROVEOUT_TEXT("Core", "A cutter of the shape {} needs the key {} ({}), e.g. {}."),
    ""};
inline constexpr FindingRow kCutterKeyMissingRange{
    Severity::error,
    false,
    "cutter-key-missing",
    PROVEOUT_TEXT("Core", "Cutter key missing"),
    PROVEOUT_TEXT("Core", "A cutter of the shape {} needs the key {} ({}, {} to {} {})."),
    ""};
inline constexpr FindingRow kCutterShapeUnknown{
    Severity::error,
    false,
    "cutter-shape-unknown",
    PROVEOUT_TEXT("Core", "Unknown cutter shape"),
    PROVEOUT_TEXT("Core", "“{}” is not a cutter shape; there are {}."),
    ""};
inline constexpr FindingRow kFlutesTooShort{
    Severity::error,
    false,
    "flutes-too-short",
    PROVEOUT_TEXT("Core", "Flute length too short"),
    PROVEOUT_TEXT("Core", "The flute length l={} is less than the height of the cutter's profile, {} mm."),
    ""};
inline constexpr FindingRow kHolderUnreadable{
    Severity::error,
    false,
    "holder-unreadable",
    PROVEOUT_TEXT("Core", "Invalid holder segment"),
    PROVEOUT_TEXT("Core", "“{}” is not a segment of a holder; a cylinder is written as {}, a cone as {}."),
    ""};
inline constexpr FindingRow kHolderSize{
    Severity::error,
    false,
    "holder-size",
    PROVEOUT_TEXT("Core", "Holder size out of range"),
    PROVEOUT_TEXT("Core",
                  "The segment {} of the holder has a diameter or height that is out of range, {} to {} mm."),
    ""};
inline constexpr FindingRow kHolderTooLong{Severity::error,
                                           false,
                                           "holder-too-long",
                                           PROVEOUT_TEXT("Core", "Too many holder segments"),
                                           PROVEOUT_TEXT("Core", "The holder has more than {} segments."),
                                           ""};
inline constexpr FindingRow kHolderWithoutStickOut{
    Severity::error,
    false,
    "holder-without-stick-out",
    PROVEOUT_TEXT("Core", "Holder without stick-out"),
    PROVEOUT_TEXT("Core", "A holder needs the key so, the stick-out from the tip to the face of the holder."),
    ""};
inline constexpr FindingRow kStickOutTooShort{
    Severity::error,
    false,
    "stick-out-too-short",
    PROVEOUT_TEXT("Core", "Stick-out too short"),
    PROVEOUT_TEXT("Core", "The stick-out so={} is less than the height of the cutter's profile, {} mm."),
    ""};
inline constexpr FindingRow kChipWithoutTeeth{
    Severity::error,
    false,
    "chip-without-teeth",
    PROVEOUT_TEXT("Core", "Chip thickness without teeth"),
    PROVEOUT_TEXT("Core",
                  "A maximum chip thickness, maxchip, needs the key z, the number of teeth of the tool."),
    ""};
inline constexpr FindingRow kToolNumberText{
    Severity::error,
    false,
    "tool-number",
    PROVEOUT_TEXT("Core", "Invalid tool number"),
    PROVEOUT_TEXT("Core", "“{}” does not begin with a tool number from {} to {}, as in {}."),
    ""};
inline constexpr FindingRow kToolFileEmpty{Severity::error,
                                           false,
                                           "tool-file-empty",
                                           PROVEOUT_TEXT("Core", "Tool file empty"),
                                           PROVEOUT_TEXT("Core", "The file holds no [[tool]] tables."),
                                           ""};
inline constexpr FindingRow kToolRow{Severity::error,
                                     false,
                                     "tool-row",
                                     PROVEOUT_TEXT("Core", "Invalid tool entry"),
                                     PROVEOUT_TEXT("Core", "A tool must be a table: [[tool]]."),
                                     ""};
inline constexpr FindingRow kToolNumber{
    Severity::error,
    false,
    "tool-number",
    PROVEOUT_TEXT("Core", "Invalid tool number"),
    PROVEOUT_TEXT("Core", "A tool needs a number, a whole one from {} to {}."),
    ""};
inline constexpr FindingRow kToolTwice{Severity::error,
                                       false,
                                       "tool-twice",
                                       PROVEOUT_TEXT("Core", "Duplicate tool"),
                                       PROVEOUT_TEXT("Core", "Tool {} is in the table twice."),
                                       ""};
inline constexpr FindingRow kToolCutter{
    Severity::error,
    false,
    "tool-cutter",
    PROVEOUT_TEXT("Core", "Tool without a cutter"),
    PROVEOUT_TEXT("Core", "Tool {} needs a cutter, e.g. cutter = \"ball:d=11,l=50\"."),
    ""};
inline constexpr FindingRow kToolSource{
    Severity::error,
    false,
    "tool-source",
    PROVEOUT_TEXT("Core", "Invalid tool source"),
    PROVEOUT_TEXT("Core", "The source of a tool is \"given\", \"comment\" or \"assumed\"."),
    ""};
inline constexpr FindingRow kToolFileSyntax{Severity::error,
                                            false,
                                            "tool-file-syntax",
                                            PROVEOUT_TEXT("Core", "Tool file not readable"),
                                            PROVEOUT_TEXT("Core", "The tool table cannot be read: {}."),
                                            ""};
inline constexpr FindingRow kToolKeyUnknownTable{
    Severity::error,
    false,
    "tool-key-unknown",
    PROVEOUT_TEXT("Core", "Unknown tool key"),
    PROVEOUT_TEXT("Core", "“{}” is not a table of a tool file; each tool is a [[tool]]."),
    ""};
inline constexpr FindingRow kToolKeyUnknownTableMeant{
    Severity::error,
    false,
    "tool-key-unknown",
    PROVEOUT_TEXT("Core", "Unknown tool key"),
    PROVEOUT_TEXT("Core", "“{}” is not a table of a tool file; perhaps “{}” is meant."),
    ""};
inline constexpr FindingRow kToolKeyUnknown{
    Severity::error,
    false,
    "tool-key-unknown",
    PROVEOUT_TEXT("Core", "Unknown tool key"),
    PROVEOUT_TEXT("Core", "“{}” is not a key of a tool; there are {}."),
    ""};
inline constexpr FindingRow kToolKeyUnknownMeant{
    Severity::error,
    false,
    "tool-key-unknown",
    PROVEOUT_TEXT("Core", "Unknown tool key"),
    PROVEOUT_TEXT("Core", "“{}” is not a key of a tool; perhaps “{}” is meant."),
    ""};

inline constexpr std::array kCutterRows{&kFormNoWidth,
                                        &kFormTooLong,
                                        &kFormTurnsBack,
                                        &kFormUnreadable,
                                        &kFormFalls,
                                        &kFormStart,
                                        &kFormArcRadius,
                                        &kFormArcCentre,
                                        &kFormArcTurns,
                                        &kFormNoTip,
                                        &kFormTooFine,
                                        &kTipTooLarge,
                                        &kPilotTooLarge,
                                        &kPilotTooShort,
                                        &kLeadTooLong,
                                        &kCornerRadiusTooLarge,
                                        &kCornerRadiusTooLargeFit,
                                        &kTaperTooLow,
                                        &kNeckTooThick,
                                        &kHeadTooHigh,
                                        &kCutterValueNotANumber,
                                        &kCutterValueNotWhole,
                                        &kCutterValueOutOfRange,
                                        &kCutterKeyTwice,
                                        &kCutterKeyUnknown,
                                        &kCutterKeyMissing,
                                        &kCutterKeyMissingRange,
                                        &kCutterShapeUnknown,
                                        &kFlutesTooShort,
                                        &kHolderUnreadable,
                                        &kHolderSize,
                                        &kHolderTooLong,
                                        &kHolderWithoutStickOut,
                                        &kStickOutTooShort,
                                        &kChipWithoutTeeth,
                                        &kToolNumberText,
                                        &kToolFileEmpty,
                                        &kToolRow,
                                        &kToolNumber,
                                        &kToolTwice,
                                        &kToolCutter,
                                        &kToolSource,
                                        &kToolFileSyntax,
                                        &kToolKeyUnknownTable,
                                        &kToolKeyUnknownTableMeant,
                                        &kToolKeyUnknown,
                                        &kToolKeyUnknownMeant};

} // namespace proveout::cutter_finding
