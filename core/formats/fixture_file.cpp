// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/fixture_file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <new>
#include <system_error>
#include <utility>
#include <vector>

#include "core/base/figures_argument.h"
#include "core/base/finding_row.h"
#include "core/base/memory.h"
#include "core/cutting/fixtures/fixture_findings.h"
#include "core/cutting/fixtures/fixture_surface.h"
#include "core/formats/mesh_findings.h"
#include "core/formats/stl.h"

namespace proveout {

namespace {

constexpr double kMostFileBytes = 400e6; ///< more than the largest number of facets takes as text
/// So many bytes are needed for a byte of the file while it is read: facets, vertices, edges.
constexpr double kBytesPerByte = 8;

Diagnostics refused(const FindingRow& row, std::vector<Argument> arguments) {
    return {diagnosticOf(row, std::move(arguments))};
}

/// Why a file is not read.
Diagnostics refusal(const std::filesystem::path& file) {
    std::error_code error;
    const auto size = static_cast<double>(std::filesystem::file_size(file, error));
    if (error)
        return {}; // the reader knows a better reason
    const double most = std::min(kMostFileBytes, static_cast<double>(memoryLimitBytes()) / 2 / kBytesPerByte);
    if (size <= most)
        return {};
    return refused(fixture_finding::kFileTooLarge,
                   {figures("{}", readableBytes(size)), figures("{}", readableBytes(most))});
}

bool isFar(const FixtureFacet& facet) {
    return std::ranges::any_of(facet, [](const glm::vec3& corner) {
        return std::max({std::abs(corner.x), std::abs(corner.y), std::abs(corner.z)}) >
               static_cast<float>(fixture_field::kFarthest);
    });
}

std::vector<FixtureFacet> facetsOf(const TriangleMesh& mesh) {
    std::vector<FixtureFacet> facets;
    facets.reserve(mesh.triangles.size());
    for (const auto& triangle : mesh.triangles)
        facets.push_back({glm::vec3(mesh.vertices[triangle[0]]), glm::vec3(mesh.vertices[triangle[1]]),
                          glm::vec3(mesh.vertices[triangle[2]])});
    return facets;
}

/// What matters to a fixture: holes, and a size that suggests another unit. The columns of an upper surface
/// are the same whatever the winding of its facets.
Diagnostics whatMatters(const StlContents& contents) {
    Diagnostics findings;
    for (const Diagnostic& warning : contents.warnings) {
        const bool hole = hasIdOf(warning, mesh_finding::kStlNotClosed) ||
                          hasIdOf(warning, mesh_finding::kStlNotFinite) ||
                          hasIdOf(warning, mesh_finding::kStlNoEndsolid);
        if (!hole && !hasIdOf(warning, mesh_finding::kStlSizeSuspectSmall))
            continue;
        findings.push_back(warning);
        findings.back().unverified = hole;
    }
    return findings;
}

std::shared_ptr<const FixtureSurface> surfaceOf(const std::filesystem::path& file) {
    const auto without = [](Diagnostics reasons) {
        return std::make_shared<const FixtureSurface>(std::vector<FixtureFacet>(), std::move(reasons));
    };
    if (Diagnostics reasons = refusal(file); !reasons.empty())
        return without(std::move(reasons));
    auto contents = readStlContents(file);
    if (!contents)
        return without(std::move(contents.error()));
    if (contents->mesh.triangles.size() > FixtureSurface::kMostFacets)
        return without(
            refused(fixture_finding::kTooManyFacets, {std::to_string(contents->mesh.triangles.size()),
                                                      std::to_string(FixtureSurface::kMostFacets)}));
    std::vector<FixtureFacet> facets = facetsOf(contents->mesh);
    if (std::ranges::any_of(facets, isFar))
        return without(refused(fixture_finding::kTooFar, {figures("{}", fixture_field::kFarthest)}));
    return std::make_shared<const FixtureSurface>(std::move(facets), whatMatters(*contents));
}

} // namespace

void readFixtureFile(FixtureMesh& mesh) {
    mesh.surface = surfaceOf(mesh.file);
}

} // namespace proveout
