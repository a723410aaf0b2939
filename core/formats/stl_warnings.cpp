// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/stl_warnings.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <limits>
#include <utility>

#include "core/base/text.h"

namespace proveout {

namespace {

/// Coordinates with a coarser float32 step than this (mm) no longer hold the detail of a part.
constexpr double kCoarseStep = 1e-3;
/// Sizes of parts, mm: smaller ones are likely to be in metres, larger ones in micrometres. No three-axis
/// mill moves farther than some metres.
constexpr double kLeastPart = 2;
constexpr double kLargestPart = 5'000;

/// A count of an STL that is a warning where it is not 0.
struct CountRow {
    const char* id;
    std::size_t (*count)(const StlContents& contents);
    const char* text; ///< of the count, and of the facets in the file
    const char* hint = "";
};

constexpr std::array kCounts{
    CountRow{"stl-not-finite", [](const StlContents& c) { return c.notFinite; },
             PROVEOUT_TEXT(
                 "Core", "{} of {} facets have a coordinate that is no finite number; they were left out.")},
    CountRow{"stl-degenerate", [](const StlContents& c) { return c.degenerate; },
             PROVEOUT_TEXT("Core", "{} of {} facets have no area; they were left out.")},
    CountRow{
        "stl-opposed-normals", [](const StlContents& c) { return c.opposedNormals; },
        PROVEOUT_TEXT("Core", "{} of {} facets have a normal against their winding; the winding counts.")},
    CountRow{"stl-duplicate-facets", [](const StlContents& c) { return c.defects.duplicateFacets; },
             PROVEOUT_TEXT("Core", "{} of {} facets are duplicates of another facet."),
             PROVEOUT_TEXT("Core", "Export the part again as one closed solid.")},
    CountRow{"stl-not-closed", [](const StlContents& c) { return c.defects.openEdges; },
             PROVEOUT_TEXT("Core", "The mesh is not closed: {} edges belong to only one facet."),
             PROVEOUT_TEXT("Core", "Export the part again as one closed solid.")},
    CountRow{"stl-not-manifold", [](const StlContents& c) { return c.defects.nonManifoldEdges; },
             PROVEOUT_TEXT("Core", "The mesh is not manifold: {} edges belong to more than two facets."),
             PROVEOUT_TEXT("Core", "Export the part again as one closed solid.")},
    CountRow{"stl-flipped-facets", [](const StlContents& c) { return c.defects.flippedEdges; },
             PROVEOUT_TEXT("Core", "The winding of the facets is inconsistent: it changes at {} edges."),
             PROVEOUT_TEXT("Core", "Export the part again as one closed solid.")},
    CountRow{"stl-inside-out",
             [](const StlContents& c) { return c.defects.insideOut ? c.mesh.triangles.size() : 0; },
             PROVEOUT_TEXT("Core", "The mesh is inside out: {} of {} facets face inwards; they are taken as "
                                   "facing outwards.")},
};

std::string sizeText(const Vec3& size) {
    return fmt::format("{:.5g} × {:.5g} × {:.5g}", size.x, size.y, size.z);
}

void warnOfPlace(const Box3& box, Diagnostics& warnings) {
    const Vec3 farthest = glm::max(glm::abs(box.lo), glm::abs(box.hi));
    const double largest = std::max({farthest.x, farthest.y, farthest.z});
    const double step = largest * static_cast<double>(std::numeric_limits<float>::epsilon());
    if (step > kCoarseStep)
        warnings.push_back(stlWarning(
            "stl-far-origin",
            PROVEOUT_TEXT("Core", "The mesh lies {} mm from the origin, where an STL file holds steps of "
                                  "{} mm only."),
            {fmt::format("{:.6g}", largest), fmt::format("{:.2g}", step)}));
}

void warnOfSize(const Vec3& size, Diagnostics& warnings) {
    const double largest = std::max({size.x, size.y, size.z});
    if (largest < kCoarseStep) {
        warnings.push_back(stlWarning(
            "stl-no-size", PROVEOUT_TEXT("Core", "The mesh is {} × {} × {} mm: hardly a part."),
            {fmt::format("{:.3g}", size.x), fmt::format("{:.3g}", size.y), fmt::format("{:.3g}", size.z)}));
        return;
    }
    if (largest >= kLeastPart && largest <= kLargestPart)
        return;
    // STL has no unit; a factor of 1000 either way is a unit that was mistaken.
    const double factor = largest < kLeastPart ? 1000 : 0.001;
    const char* const text =
        largest < kLeastPart
            ? PROVEOUT_TEXT("Core", "The mesh is only {} mm in size; in metres it would be {} mm.")
            : PROVEOUT_TEXT("Core", "The mesh is {} mm in size; in micrometres it would be {} mm.");
    warnings.push_back(stlWarning("stl-size-suspect", text, {sizeText(size), sizeText(size * factor)}));
    warnings.back().hint = PROVEOUT_TEXT("Core", "Export the part in millimetres; STL files have no unit.");
}

} // namespace

Diagnostic stlWarning(const char* id, const char* text, std::vector<std::string> arguments) {
    Diagnostic diagnostic;
    diagnostic.severity = Severity::warning;
    diagnostic.id = id;
    diagnostic.text = text;
    diagnostic.arguments = std::move(arguments);
    return diagnostic;
}

void warnOfStl(StlContents& contents) {
    for (const CountRow& row : kCounts) {
        const std::size_t count = row.count(contents);
        if (count == 0)
            continue;
        contents.warnings.push_back(
            stlWarning(row.id, row.text, {std::to_string(count), std::to_string(contents.facets)}));
        contents.warnings.back().hint = row.hint;
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
