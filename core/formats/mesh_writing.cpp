// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/mesh_writing.h"

#include <cmath>
#include <fmt/format.h>

#include "core/base/text.h"

namespace proveout {

Result<void> checkNotEmpty(const std::filesystem::path& file, const TriangleMesh& mesh) {
    if (mesh.triangles.empty())
        return failure("nothing-left",
                       PROVEOUT_TEXT("Core", "Nothing of the stock is left, so there is no mesh to write."),
                       {}, file.string());
    return {};
}

Result<void> checkFinite(const std::filesystem::path& file, const TriangleMesh& mesh) {
    for (const Vec3& vertex : mesh.vertices)
        if (!std::isfinite(vertex.x) || !std::isfinite(vertex.y) || !std::isfinite(vertex.z))
            return failure(
                "mesh-coordinate",
                PROVEOUT_TEXT("Core", "A vertex lies at {}, {}, {}: a mesh file holds finite numbers only."),
                {fmt::format("{}", vertex.x), fmt::format("{}", vertex.y), fmt::format("{}", vertex.z)},
                file.string());
    return {};
}

tl::unexpected<Diagnostics> MeshBatches::cancelled() const {
    return failure("cancelled", PROVEOUT_TEXT("Core", "Cancelled; no file was written."), {},
                   m_file.string());
}

} // namespace proveout
