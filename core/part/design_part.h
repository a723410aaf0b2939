// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/triangle_mesh.h"
#include "core/part/part_distance.h"

namespace proveout {

/// The part as it was designed, program coordinates, mm. Immutable; any thread.
class DesignPart {
public:
    /// The mesh has facets, its coordinates are finite, its indices in range. Takes some 0.6 s for a million
    /// facets.
    explicit DesignPart(TriangleMesh mesh);

    [[nodiscard]] const TriangleMesh& mesh() const { return m_mesh; }
    [[nodiscard]] const Box3& box() const { return m_box; }
    [[nodiscard]] const PartDistance& distance() const { return m_distance; }
    [[nodiscard]] std::array<Vec3, 3> corners(std::size_t facet) const {
        const auto& [a, b, c] = m_mesh.triangles[facet];
        return {m_mesh.vertices[a], m_mesh.vertices[b], m_mesh.vertices[c]};
    }

    /// The memory for a part with so many facets.
    [[nodiscard]] static double bytes(std::size_t facets) { return 400.0 * static_cast<double>(facets); }

private:
    TriangleMesh m_mesh;
    Box3 m_box;
    PartDistance m_distance;
};

} // namespace proveout
