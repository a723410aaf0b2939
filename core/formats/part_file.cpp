// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/part_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numbers>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "core/base/figures_argument.h"
#include "core/base/finding_row.h"
#include "core/base/memory.h"
#include "core/formats/mesh_findings.h"
#include "core/formats/stl.h"
#include "core/part/part_findings.h"

namespace proveout {

namespace {

/// A file of STL needs so many bytes for each of its own while it is read, and then for the part.
constexpr double kBytesOfFileByte = 10;

std::string endingOf(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return ending;
}

Result<void> checkSize(double needed, std::uint64_t memoryBytes) {
    if (needed <= static_cast<double>(memoryBytes))
        return {};
    return failure(part_finding::kTooLarge, {figures("{}", readableBytes(needed)),
                                             figures("{}", readableBytes(static_cast<double>(memoryBytes)))});
}

/// Leaves out facets with the vertices of an earlier one; returns how many.
std::size_t removeDuplicates(TriangleMesh& mesh) {
    std::vector<std::pair<std::array<std::uint32_t, 3>, std::size_t>> sorted(mesh.triangles.size());
    for (std::size_t k = 0; k < sorted.size(); ++k) {
        sorted[k] = {mesh.triangles[k], k};
        std::ranges::sort(sorted[k].first);
    }
    std::ranges::sort(sorted);
    std::vector<bool> isTwice(sorted.size());
    for (std::size_t k = 1; k < sorted.size(); ++k)
        isTwice[sorted[k].second] = sorted[k].first == sorted[k - 1].first;
    std::vector<std::array<std::uint32_t, 3>> kept;
    kept.reserve(sorted.size());
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k)
        if (!isTwice[k])
            kept.push_back(mesh.triangles[k]);
    const std::size_t removed = mesh.triangles.size() - kept.size();
    mesh.triangles = std::move(kept);
    return removed;
}

void place(TriangleMesh& mesh, const PartSpec& spec) {
    const double angle = spec.turn * std::numbers::pi / 180;
    const double cosine = std::cos(angle);
    const double sine = std::sin(angle);
    for (Vec3& vertex : mesh.vertices) {
        const Vec3 scaled = vertex * spec.scale;
        vertex = Vec3(cosine * scaled.x - sine * scaled.y, sine * scaled.x + cosine * scaled.y, scaled.z) +
                 Vec3(spec.x, spec.y, spec.z);
    }
}

/// Repairs what is safe.
Result<Diagnostics> repair(StlContents& contents) {
    Diagnostics findings;
    for (const Diagnostic& warning : contents.warnings)
        if (hasIdOf(warning, mesh_finding::kStlSizeSuspectSmall) ||
            hasIdOf(warning, mesh_finding::kStlNotFinite) || hasIdOf(warning, mesh_finding::kStlNoEndsolid))
            findings.push_back(warning);
    if (const std::size_t removed = removeDuplicates(contents.mesh); removed > 0) {
        findings.push_back(diagnosticOf(part_finding::kDuplicates, {std::to_string(removed)}));
        contents.defects = findDefects(contents.mesh);
    }
    const MeshDefects& defects = contents.defects;
    if (defects.flippedEdges > 0)
        return failure(part_finding::kWinding, {std::to_string(defects.flippedEdges)});
    if (defects.insideOut) {
        for (auto& triangle : contents.mesh.triangles)
            std::swap(triangle[1], triangle[2]);
        findings.push_back(
            diagnosticOf(part_finding::kTurnedOver, {std::to_string(contents.mesh.triangles.size())}));
    }
    if (defects.openEdges > 0)
        findings.push_back(diagnosticOf(part_finding::kOpen, {std::to_string(defects.openEdges)}));
    if (defects.nonManifoldEdges > 0)
        findings.push_back(diagnosticOf(part_finding::kTouching, {std::to_string(defects.nonManifoldEdges)}));
    return findings;
}

Result<PartContents> read(const PartSpec& spec, std::uint64_t memoryBytes) {
    if (const std::string ending = endingOf(spec.file); ending != ".stl")
        return failure(part_finding::kFormat, {ending}, spec.file.string());
    std::error_code error;
    const auto size = static_cast<double>(std::filesystem::file_size(spec.file, error));
    if (!error) // otherwise the reader knows a better reason
        if (auto fits = checkSize(size * kBytesOfFileByte, memoryBytes); !fits)
            return tl::unexpected(std::move(fits.error()));
    auto contents = readStlContents(spec.file);
    if (!contents)
        return tl::unexpected(std::move(contents.error()));
    if (auto fits = checkSize(DesignPart::bytes(contents->mesh.triangles.size()), memoryBytes); !fits)
        return tl::unexpected(std::move(fits.error()));
    auto findings = repair(*contents);
    if (!findings)
        return tl::unexpected(std::move(findings.error()));
    place(contents->mesh, spec);
    return PartContents{std::make_shared<const DesignPart>(std::move(contents->mesh)), std::move(*findings)};
}

} // namespace

PartContents readPart(const PartSpec& spec, std::uint64_t memoryBytes) {
    auto contents = read(spec, memoryBytes);
    if (contents)
        return std::move(*contents);
    Diagnostic unread = diagnosticOf(part_finding::kUnread, {message(contents.error().front())});
    unread.file = spec.file.string();
    return {.findings = {std::move(unread)}};
}

} // namespace proveout
