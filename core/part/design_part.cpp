// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/part/design_part.h"

#include <utility>

namespace proveout {

namespace {

Box3 boxOf(const TriangleMesh& mesh) {
    Box3 box;
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t vertex : triangle)
            box.add(mesh.vertices[vertex]);
    return box;
}

} // namespace

DesignPart::DesignPart(TriangleMesh mesh)
    : m_mesh(std::move(mesh)), m_box(boxOf(m_mesh)), m_distance(m_mesh.vertices, m_mesh.triangles) {}

} // namespace proveout
