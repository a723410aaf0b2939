// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/stl_warnings.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <limits>
#include <utility>

#include "core/base/figures_argument.h"
#include "core/formats/mesh_findings.h"

namespace proveout {

namespace {

/// Coordinates with a coarser float32 step than this (mm) no longer represent the detail of a part.
constexpr double kCoarseStep = 1e-3;
/// Sizes of parts, mm: smaller ones are probably in metres, larger ones in micrometres. No three-axis mill
/// moves farther than some metres.
constexpr double kLeastPart = 2;
constexpr double kLargestPart = 5'000;

/// A count of an STL that is reported as a warning if it is not 0. Its sentence has the count and the number
/// of facets in the file.
struct CountRow {
    const FindingRow* finding;
    std::size_t (*count)(const StlContents& contents);
};

constexpr std::array kCounts{
    CountRow{&mesh_finding::kStlNotFinite, [](const StlContents& c) { return c.notFinite; }},
    CountRow{&mesh_finding::kStlDegenerate, [](const StlContents& c) { return c.degenerate; }},
    CountRow{&mesh_finding::kStlOpposedNormals, [](const StlContents& c) { return c.opposedNormals; }},
    CountRow{&mesh_finding::kStlDuplicateFacets,
             [](const StlContents& c) { return c.defects.duplicateFacets; }},
    CountRow{&mesh_finding::kStlNotClosed, [](const StlContents& c) { return c.defects.openEdges; }},
    CountRow{&mesh_finding::kStlNotManifold, [](const StlContents& c) { return c.defects.nonManifoldEdges; }},
    CountRow{&mesh_finding::kStlFlippedFacets, [](const StlContents& c) { return c.defects.flippedEdges; }},
    CountRow{&mesh_finding::kStlInsideOut,
             [](const StlContents& c) { return c.defects.insideOut ? c.mesh.triangles.size() : 0; }},
};

Argument sizeText(const Vec3& size) {
    return figures("{:.5g} × {:.5g} × {:.5g}", size.x, size.y, size.z);
}

void warnOfPlace(const Box3& box, Diagnostics& warnings) {
    const Vec3 farthest = glm::max(glm::abs(box.lo), glm::abs(box.hi));
    const double largest = std::max({farthest.x, farthest.y, farthest.z});
    const double step = largest * static_cast<double>(std::numeric_limits<float>::epsilon());
    if (step > kCoarseStep)
        warnings.push_back(
            diagnosticOf(mesh_finding::kStlFarOrigin, {figures("{:.6g}", largest), figures("{:.2g}", step)}));
}

void warnOfSize(const Vec3& size, Diagnostics& warnings) {
    const double largest = std::max({size.x, size.y, size.z});
    if (largest < kCoarseStep) {
        warnings.push_back(
            diagnosticOf(mesh_finding::kStlNoSize,
                         {figures("{:.3g}", size.x), figures("{:.3g}", size.y), figures("{:.3g}", size.z)}));
        return;
    }
    if (largest >= kLeastPart && largest <= kLargestPart)
        return;
    // STL has no unit; a factor of 1000 either way indicates a mistaken unit.
    const double factor = largest < kLeastPart ? 1000 : 0.001;
    const FindingRow& row =
        largest < kLeastPart ? mesh_finding::kStlSizeSuspectSmall : mesh_finding::kStlSizeSuspectLarge;
    warnings.push_back(diagnosticOf(row, {sizeText(size), sizeText(size * factor)}));
}

} // namespace

void warnOfStl(StlContents& contents) {
    for (const CountRow& row : kCounts) {
        const std::size_t count = row.count(contents);
        if (count == 0)
            continue;
        contents.warnings.push_back(
            diagnosticOf(*row.finding, {std::to_string(count), std::to_string(contents.facets)}));
    }
    Box3 box;
    for (const Vec3& vertex : contents.mesh.vertices)
        box.add(vertex);
    if (box.empty())
        return;
    warnOfSize(box.hi - box.lo, contents.warnings);
    warnOfPlace(box, contents.warnings);
}

} // namespace proveout
