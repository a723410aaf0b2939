// SPDX-License-Identifier: GPL-3.0-or-later
// Findings about mesh files that are written.
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::export_finding {

inline constexpr FindingRow kExportFormatUnknown{
    Severity::error,
    false,
    "export-format-unknown",
    PROVEOUT_TEXT("Core", "Unknown export format"),
    PROVEOUT_TEXT("Core", "The extension of this name is not that of a mesh format; there are {}."),
    ""};
inline constexpr FindingRow kExportRoundedBeyond{
    Severity::warning,
    false,
    "export-rounded-beyond",
    PROVEOUT_TEXT("Core", "Export rounded too coarsely"),
    PROVEOUT_TEXT("Core",
                  "Rounded to single precision, the mesh deviates from the z-map by up to {} mm, "
                  "more than the error allowance of {} mm; a format in double precision would keep {} mm."),
    PROVEOUT_TEXT("Core", "Export to a format with coordinates in double precision: {4}.")};
inline constexpr FindingRow kExportSetApart{
    Severity::warning,
    false,
    "export-set-apart",
    PROVEOUT_TEXT("Core", "Touching parts set apart"),
    PROVEOUT_TEXT("Core", "The mesh deviates from the z-map by up to {} mm, more than the error allowance of "
                          "{} mm, where parts of the solid that touch at a steep wall are set apart."),
    PROVEOUT_TEXT("Core", "Make the stock slightly lower or higher, so that cuts do not end at its floor.")};
inline constexpr FindingRow kExportWallsOnGrid{
    Severity::note,
    false,
    "export-walls-on-grid",
    PROVEOUT_TEXT("Core", "Walls at grid points"),
    PROVEOUT_TEXT("Core",
                  "{} of {} points beside walls are at points of the grid in the file: the grid does not "
                  "resolve the walls around them."),
    PROVEOUT_TEXT("Core", "Use a finer grid for walls that are close together.")};
inline constexpr FindingRow kExportWallsUnknown{
    Severity::note,
    false,
    "export-walls-unknown",
    PROVEOUT_TEXT("Core", "Walls at grid points"),
    PROVEOUT_TEXT("Core", "Some walls in the file are at points of the grid: in {} of {} squares of 64 × 64 "
                          "points, more than {} motions of the program are near the walls, or the walls of "
                          "the stock are unknown."),
    PROVEOUT_TEXT("Core", "Use a finer grid, so that fewer motions are over each square, or a stock whose "
                          "walls are known.")};
inline constexpr FindingRow kExportRibsUnseen{
    Severity::note,
    false,
    "export-ribs-unseen",
    PROVEOUT_TEXT("Core", "Ribs between grid points"),
    PROVEOUT_TEXT("Core", "Ribs thinner than the grid spacing are missing from the file: {} places between "
                          "grid points, the first at X{} Y{}."),
    PROVEOUT_TEXT("Core", "Use a finer grid, or look at these places in a detail region.")};
inline constexpr FindingRow kExportRoundingTooLarge{
    Severity::error,
    false,
    "export-rounding-too-large",
    PROVEOUT_TEXT("Core", "Rounding too large"),
    PROVEOUT_TEXT(
        "Core",
        "Single precision rounds positions in this stock by up to {} mm, more than half of the error "
        "allowance of {} mm; an allowance of at least {} mm or a format in double precision is needed."),
    PROVEOUT_TEXT("Core", "Export to a format with coordinates in double precision ({4}), or move the stock "
                          "nearer to the origin.")};
inline constexpr FindingRow kExportWallsTooSteep{
    Severity::error,
    false,
    "export-rounding-too-large",
    PROVEOUT_TEXT("Core", "Rounding too large"),
    PROVEOUT_TEXT(
        "Core", "Rounding to single precision changes heights on steep walls by up to {} mm, more than half "
                "of the error allowance of {} mm; an allowance of about {} mm or a format in double "
                "precision is needed."),
    PROVEOUT_TEXT("Core", "Export to a format with coordinates in double precision ({4}), or move the stock "
                          "nearer to the origin.")};
inline constexpr FindingRow kNothingLeft{Severity::error,
                                         false,
                                         "nothing-left",
                                         PROVEOUT_TEXT("Core", "Nothing to export"),
                                         PROVEOUT_TEXT("Core", "There is no stock left to export."),
                                         ""};
inline constexpr FindingRow kMeshCoordinate{
    Severity::error,
    false,
    "mesh-coordinate",
    PROVEOUT_TEXT("Core", "Coordinate not finite"),
    PROVEOUT_TEXT("Core", "The vertex {}, {}, {} is not finite: a mesh file holds finite numbers only."),
    ""};
inline constexpr FindingRow kCancelledWriting{Severity::error,
                                              false,
                                              "cancelled",
                                              PROVEOUT_TEXT("Core", "Cancelled"),
                                              PROVEOUT_TEXT("Core", "Cancelled; no file was written."),
                                              ""};
inline constexpr FindingRow kStlTooCoarse{
    Severity::error,
    false,
    "stl-too-coarse",
    PROVEOUT_TEXT("Core", "STL too coarse"),
    PROVEOUT_TEXT("Core",
                  "The coordinates of an STL file are too coarse for this mesh so far from the origin: {} "
                  "triangles would collapse or turn over, {} vertices meet others; a format in double "
                  "precision can hold it."),
    PROVEOUT_TEXT("Core", "Export to a format with coordinates in double precision: {3}.")};
inline constexpr FindingRow kStlTooManyTriangles{
    Severity::error,
    false,
    "stl-too-many-triangles",
    PROVEOUT_TEXT("Core", "Too many triangles"),
    PROVEOUT_TEXT("Core", "The mesh has {} triangles; an STL file holds 4294967295."),
    ""};
inline constexpr FindingRow kGlbTooLarge{
    Severity::error,
    false,
    "glb-too-large",
    PROVEOUT_TEXT("Core", "GLB file too large"),
    PROVEOUT_TEXT("Core",
                  "The mesh of {} triangles needs more than {} bytes, the most that a GLB file holds."),
    PROVEOUT_TEXT("Core", "Export with a larger error allowance, or to another format.")};
inline constexpr FindingRow kStlCoordinate{
    Severity::error,
    false,
    "stl-coordinate",
    PROVEOUT_TEXT("Core", "Coordinate out of range"),
    PROVEOUT_TEXT("Core", "The vertex {}, {}, {} is out of the range of single precision."),
    ""};

inline constexpr std::array kExportRows{&kExportFormatUnknown,    &kExportRoundedBeyond, &kExportSetApart,
                                        &kExportWallsOnGrid,      &kExportWallsUnknown,  &kExportRibsUnseen,
                                        &kExportRoundingTooLarge, &kExportWallsTooSteep, &kNothingLeft,
                                        &kMeshCoordinate,         &kCancelledWriting,    &kStlTooCoarse,
                                        &kStlTooManyTriangles,    &kGlbTooLarge,         &kStlCoordinate};

} // namespace proveout::export_finding
