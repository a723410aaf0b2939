// SPDX-License-Identifier: GPL-3.0-or-later
// Findings about the design part, and about a stock that is compared with it.
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::part_finding {

// Of its description.
inline constexpr FindingRow kKey{Severity::error,
                                 false,
                                 "part-key",
                                 PROVEOUT_TEXT("Core", "Unknown key of part"),
                                 PROVEOUT_TEXT("Core", "The design part has no \"{}\"; it has {}."),
                                 ""};
inline constexpr FindingRow kValue{
    Severity::error,
    false,
    "part-value",
    PROVEOUT_TEXT("Core", "Invalid value of part"),
    PROVEOUT_TEXT("Core", "\"{}\" of the design part must be a number from {} to {}."),
    ""};
inline constexpr FindingRow kNoFile{
    Severity::error,
    false,
    "part-file",
    PROVEOUT_TEXT("Core", "Part without a file"),
    PROVEOUT_TEXT("Core", "The design part needs the name of its file, as in x=0,y=0,z=0,file=part.stl."),
    ""};

// Of its file, without which the program is checked, but not the part.
/// Argument: the reason.
inline constexpr FindingRow kUnread{
    Severity::error,
    true,
    "part-unread",
    PROVEOUT_TEXT("Core", "Part not compared"),
    PROVEOUT_TEXT("Core", "The stock is not compared with the part, because its file cannot be used: {}"),
    PROVEOUT_TEXT("Core", "Correct the file, or choose another one.")};
inline constexpr FindingRow kNoStock{
    Severity::error,
    true,
    "part-unread",
    PROVEOUT_TEXT("Core", "Part not compared"),
    PROVEOUT_TEXT("Core",
                  "The program is checked without a stock, so there is nothing to compare with the part."),
    PROVEOUT_TEXT("Core", "State the stock.")};
/// Argument: the ending of the file.
inline constexpr FindingRow kFormat{
    Severity::error,
    false,
    "part-format",
    PROVEOUT_TEXT("Core", "Format of part unknown"),
    PROVEOUT_TEXT("Core", "A design part cannot be read from a file that ends in \"{}\"."),
    PROVEOUT_TEXT("Core", "Export the part as STL.")};
/// Arguments: the size of the file, or of the part in memory, and the limit.
inline constexpr FindingRow kTooLarge{Severity::error,
                                      false,
                                      "part-too-large",
                                      PROVEOUT_TEXT("Core", "Part too large"),
                                      PROVEOUT_TEXT("Core", "The part needs {}; {} are available."),
                                      PROVEOUT_TEXT("Core", "Export the part with fewer facets.")};
/// Argument: how many edges.
inline constexpr FindingRow kWinding{
    Severity::error,
    false,
    "part-winding",
    PROVEOUT_TEXT("Core", "Part turned over in places"),
    PROVEOUT_TEXT("Core",
                  "Neighbouring facets of the part face to opposite sides at {} edges, so that inside "
                  "and outside are not known."),
    PROVEOUT_TEXT("Core", "Export the part again as one closed solid.")};
/// Argument: the number of facets.
inline constexpr FindingRow kTurnedOver{
    Severity::warning,
    false,
    "part-repaired",
    PROVEOUT_TEXT("Core", "Part repaired"),
    PROVEOUT_TEXT("Core", "The part is inside out; all {} facets were turned over."),
    kWinding.hint};
inline constexpr FindingRow kDuplicates{
    Severity::warning,
    false,
    "part-repaired",
    PROVEOUT_TEXT("Core", "Part repaired"),
    PROVEOUT_TEXT("Core", "{} facets of the part are there twice; one of each was left out."),
    kWinding.hint};
/// Argument: how many edges.
inline constexpr FindingRow kOpen{
    Severity::warning,
    true,
    "part-not-closed",
    PROVEOUT_TEXT("Core", "Part not closed"),
    PROVEOUT_TEXT("Core", "The part is not closed at {} edges; places next to them are not judged."),
    PROVEOUT_TEXT("Core", "Export the part again as one closed solid.")};
/// Argument: how many edges.
inline constexpr FindingRow kTouching{
    Severity::warning,
    false,
    "part-not-manifold",
    PROVEOUT_TEXT("Core", "Part touches itself"),
    PROVEOUT_TEXT("Core", "At {} edges of the part more than two facets meet."),
    kOpen.hint};

// Of a comparison. Arguments of the first two: the largest deviation, what is allowed.
inline constexpr FindingRow kGouge{
    Severity::fault,
    false,
    "gouge",
    PROVEOUT_TEXT("Core", "Part gouged"),
    PROVEOUT_TEXT("Core", "The tool cuts {} mm into the part; {} mm are allowed."),
    PROVEOUT_TEXT("Core", "Correct the toolpath, the tool or its length, or allow more.")};
inline constexpr FindingRow kExcess{
    Severity::fault,
    false,
    "excess",
    PROVEOUT_TEXT("Core", "Stock left on part"),
    PROVEOUT_TEXT("Core", "{} mm of stock are left on the part; {} mm are allowed."),
    PROVEOUT_TEXT("Core", "Machine what is left, or state the allowance if it is to stay.")};
inline constexpr FindingRow kNeverThere{
    Severity::fault,
    false,
    "gouge",
    PROVEOUT_TEXT("Core", "Part gouged"),
    PROVEOUT_TEXT("Core", "{} mm of the part are missing where no tool cuts; {} mm are allowed."),
    PROVEOUT_TEXT("Core", "Check the size and the position of the stock and of the part.")};
/// Arguments: by how much, the side.
inline constexpr FindingRow kOutsideStock{
    Severity::error,
    true,
    "part-outside-stock",
    PROVEOUT_TEXT("Core", "Part outside of stock"),
    PROVEOUT_TEXT("Core", "The part reaches {} mm beyond the stock ({}); it is not compared there."),
    PROVEOUT_TEXT("Core", "Check the position of the part, its unit, and the stock.")};
/// Argument: the fraction of the part, %.
inline constexpr FindingRow kMisplaced{
    Severity::error,
    true,
    "part-misplaced",
    PROVEOUT_TEXT("Core", "Part misplaced"),
    PROVEOUT_TEXT("Core", "Only {} % of the part are within the stock: it is not compared."),
    PROVEOUT_TEXT("Core", "Check the position of the part, its unit, and the stock.")};
inline constexpr FindingRow kSideUnknown{
    Severity::error,
    true,
    "part-side-unknown",
    PROVEOUT_TEXT("Core", "Inside of part unknown"),
    PROVEOUT_TEXT("Core",
                  "At {} points the mesh does not tell whether they are inside or outside of the part."),
    PROVEOUT_TEXT("Core", "Export the part again as one closed solid without overlapping bodies.")};
inline constexpr FindingRow kUnresolved{
    Severity::error,
    true,
    "part-walls-unresolved",
    PROVEOUT_TEXT("Core", "Walls not resolved"),
    PROVEOUT_TEXT("Core", "{} mm² of the steep faces of the part cannot be judged at this grid spacing."),
    PROVEOUT_TEXT("Core", "Choose a finer grid, or a wider tolerance.")};
/// Argument: how many edges of the grid.
inline constexpr FindingRow kRibsUnseen{
    Severity::error,
    true,
    "part-ribs-unseen",
    PROVEOUT_TEXT("Core", "Ribs between grid points"),
    PROVEOUT_TEXT("Core",
                  "Thin ribs are left at {} places between the points of the grid, and are not compared."),
    PROVEOUT_TEXT("Core", "Choose a finer grid.")};
inline constexpr FindingRow kUndercut{
    Severity::note,
    false,
    "part-undercut",
    PROVEOUT_TEXT("Core", "Undercut of part"),
    PROVEOUT_TEXT("Core",
                  "{} mm² of the part are below other faces of it, where no tool reaches them along Z; "
                  "stock is left there."),
    ""};

/// Those that refuse the description of a part.
inline constexpr std::array kPartRows{&kKey, &kValue, &kNoFile};
inline constexpr std::array kComparisonRows{
    &kUnread,     &kNoStock,      &kFormat,    &kTooLarge,    &kWinding,    &kTurnedOver,
    &kDuplicates, &kOpen,         &kTouching,  &kRibsUnseen,  &kGouge,      &kExcess,
    &kNeverThere, &kOutsideStock, &kMisplaced, &kSideUnknown, &kUnresolved, &kUndercut};

} // namespace proveout::part_finding
