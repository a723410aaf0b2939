// SPDX-License-Identifier: GPL-3.0-or-later
// Findings about mesh files that are read.
#pragma once

#include <array>

#include "core/base/finding_row.h"
#include "core/base/text.h"

namespace proveout::mesh_finding {

inline constexpr FindingRow kStlCutOffFacets{
    Severity::error,
    false,
    "stl-cut-off",
    PROVEOUT_TEXT("Core", "STL file cut off"),
    PROVEOUT_TEXT("Core", "The header specifies {} facets, but the file ends at byte {}, after {}."),
    ""};
inline constexpr FindingRow kStlCutOffHeader{
    Severity::error,
    false,
    "stl-cut-off",
    PROVEOUT_TEXT("Core", "STL file cut off"),
    PROVEOUT_TEXT("Core", "This is not an STL file: it ends at byte {}, within the header."),
    ""};
inline constexpr FindingRow kStlCutOff{Severity::error,
                                       false,
                                       "stl-cut-off",
                                       PROVEOUT_TEXT("Core", "STL file cut off"),
                                       PROVEOUT_TEXT("Core", "Expected \"{}\" but the file ends."),
                                       ""};
inline constexpr FindingRow kStlSyntax{Severity::error,
                                       false,
                                       "stl-syntax",
                                       PROVEOUT_TEXT("Core", "STL syntax error"),
                                       PROVEOUT_TEXT("Core", "Expected \"{2}\" but found \"{1}\"."),
                                       ""};
inline constexpr FindingRow kNotStl{Severity::error,
                                    false,
                                    "not-stl",
                                    PROVEOUT_TEXT("Core", "Not an STL file"),
                                    PROVEOUT_TEXT("Core", "This is not an STL file."),
                                    ""};
inline constexpr FindingRow kStlNoFacets{
    Severity::error,
    false,
    "stl-no-facets",
    PROVEOUT_TEXT("Core", "No usable facets"),
    PROVEOUT_TEXT("Core",
                  "The file holds no facet that could be used ({} read, {} not finite, {} without area)."),
    ""};
inline constexpr FindingRow kStlTrailingBytes{
    Severity::warning,
    false,
    "stl-trailing-bytes",
    PROVEOUT_TEXT("Core", "Data after STL end"),
    PROVEOUT_TEXT("Core",
                  "The {} facets specified in the header were read; {} bytes follow them from byte {}."),
    ""};
inline constexpr FindingRow kStlNoEndsolid{
    Severity::warning,
    false,
    "stl-no-endsolid",
    PROVEOUT_TEXT("Core", "STL end missing"),
    PROVEOUT_TEXT("Core", "The file ends without \"endsolid\"; it may have been cut off."),
    ""};
inline constexpr FindingRow kStlNotFinite{
    Severity::warning,
    false,
    "stl-not-finite",
    PROVEOUT_TEXT("Core", "Facets not finite"),
    PROVEOUT_TEXT("Core",
                  "{} of {} facets have a coordinate that is not a finite number; they were ignored."),
    ""};
inline constexpr FindingRow kStlDegenerate{
    Severity::warning,
    false,
    "stl-degenerate",
    PROVEOUT_TEXT("Core", "Degenerate facets"),
    PROVEOUT_TEXT("Core", "{} of {} facets have no area; they were ignored."),
    ""};
inline constexpr FindingRow kStlOpposedNormals{
    Severity::warning,
    false,
    "stl-opposed-normals",
    PROVEOUT_TEXT("Core", "Normals against winding"),
    PROVEOUT_TEXT("Core", "{} of {} facets have a normal against their winding; the winding counts."),
    ""};
inline constexpr FindingRow kStlDuplicateFacets{
    Severity::warning,
    false,
    "stl-duplicate-facets",
    PROVEOUT_TEXT("Core", "Duplicate facets"),
    PROVEOUT_TEXT("Core", "{} of {} facets are duplicates of another facet."),
    PROVEOUT_TEXT("Core", "Export the part again as one closed solid.")};
inline constexpr FindingRow kStlNotClosed{
    Severity::warning,
    false,
    "stl-not-closed",
    PROVEOUT_TEXT("Core", "Mesh not closed"),
    PROVEOUT_TEXT("Core", "The mesh is not closed: {} edges belong to only one facet."),
    PROVEOUT_TEXT("Core", "Export the part again as one closed solid.")};
inline constexpr FindingRow kStlNotManifold{
    Severity::warning,
    false,
    "stl-not-manifold",
    PROVEOUT_TEXT("Core", "Mesh not manifold"),
    PROVEOUT_TEXT("Core", "The mesh is not manifold: {} edges belong to more than two facets."),
    PROVEOUT_TEXT("Core", "Export the part again as one closed solid.")};
inline constexpr FindingRow kStlFlippedFacets{
    Severity::warning,
    false,
    "stl-flipped-facets",
    PROVEOUT_TEXT("Core", "Flipped facets"),
    PROVEOUT_TEXT("Core", "The winding of the facets is inconsistent: it changes at {} edges."),
    PROVEOUT_TEXT("Core", "Export the part again as one closed solid.")};
inline constexpr FindingRow kStlInsideOut{
    Severity::warning,
    false,
    "stl-inside-out",
    PROVEOUT_TEXT("Core", "Mesh inside out"),
    PROVEOUT_TEXT("Core",
                  "The mesh is inside out: {} of {} facets face inwards; they are taken as facing outwards."),
    ""};
inline constexpr FindingRow kStlFarOrigin{
    Severity::warning,
    false,
    "stl-far-origin",
    PROVEOUT_TEXT("Core", "Mesh far from origin"),
    PROVEOUT_TEXT("Core",
                  "The mesh is {} mm from the origin, where an STL file resolves steps of {} mm only."),
    ""};
inline constexpr FindingRow kStlNoSize{Severity::warning,
                                       false,
                                       "stl-no-size",
                                       PROVEOUT_TEXT("Core", "Mesh without size"),
                                       PROVEOUT_TEXT("Core", "The mesh is {} × {} × {} mm: hardly a part."),
                                       ""};
inline constexpr FindingRow kStlSizeSuspectSmall{
    Severity::warning,
    false,
    "stl-size-suspect",
    PROVEOUT_TEXT("Core", "Mesh size suspect"),
    PROVEOUT_TEXT("Core", "The mesh is only {} mm in size; in metres it would be {} mm."),
    PROVEOUT_TEXT("Core", "Export the part in millimetres; STL files have no unit.")};
inline constexpr FindingRow kStlSizeSuspectLarge{
    Severity::warning,
    false,
    "stl-size-suspect",
    PROVEOUT_TEXT("Core", "Mesh size suspect"),
    PROVEOUT_TEXT("Core", "The mesh is {} mm in size; in micrometres it would be {} mm."),
    PROVEOUT_TEXT("Core", "Export the part in millimetres; STL files have no unit.")};
inline constexpr FindingRow kFileNotZip{
    Severity::error,
    false,
    "file-not-zip",
    PROVEOUT_TEXT("Core", "Not a ZIP archive"),
    PROVEOUT_TEXT("Core", "This is not a ZIP archive, or one that cannot be read."),
    ""};

inline constexpr std::array kMeshRows{
    &kStlCutOffFacets,   &kStlCutOffHeader,    &kStlCutOff,     &kStlSyntax,           &kNotStl,
    &kStlNoFacets,       &kStlTrailingBytes,   &kStlNoEndsolid, &kStlNotFinite,        &kStlDegenerate,
    &kStlOpposedNormals, &kStlDuplicateFacets, &kStlNotClosed,  &kStlNotManifold,      &kStlFlippedFacets,
    &kStlInsideOut,      &kStlFarOrigin,       &kStlNoSize,     &kStlSizeSuspectSmall, &kStlSizeSuspectLarge,
    &kFileNotZip};

} // namespace proveout::mesh_finding
