// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/mesh_writing.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "core/base/figures_argument.h"
#include "core/formats/export_findings.h"

namespace proveout {

Result<void> checkNotEmpty(const std::filesystem::path& file, const TriangleMesh& mesh) {
    if (mesh.triangles.empty())
        return failure(export_finding::kNothingLeft, {}, file.string());
    return {};
}

Result<void> checkFinite(const std::filesystem::path& file, const TriangleMesh& mesh) {
    for (const Vec3& vertex : mesh.vertices)
        if (!std::isfinite(vertex.x) || !std::isfinite(vertex.y) || !std::isfinite(vertex.z))
            return failure(export_finding::kMeshCoordinate,
                           {figures("{}", vertex.x), figures("{}", vertex.y), figures("{}", vertex.z)},
                           file.string());
    return {};
}

Result<void> checkSinglePrecision(const std::filesystem::path& file, const TriangleMesh& mesh) {
    for (const Vec3& vertex : mesh.vertices) {
        const double largest = std::max({std::abs(vertex.x), std::abs(vertex.y), std::abs(vertex.z)});
        if (!(largest <= static_cast<double>(std::numeric_limits<float>::max())) ||
            glm::any(glm::isnan(vertex)))
            return failure(export_finding::kStlCoordinate,
                           {figures("{}", vertex.x), figures("{}", vertex.y), figures("{}", vertex.z)},
                           file.string());
    }
    return {};
}

tl::unexpected<Diagnostics> MeshBatches::cancelled() const {
    return failure(export_finding::kCancelledWriting, {}, m_file.string());
}

} // namespace proveout
