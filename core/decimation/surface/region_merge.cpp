// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/surface/region_merge.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "core/decimation/lattice/patch_mesh.h"

namespace proveout {

RegionMeshPtr RegionMerge::merge(const RegionGrid& grid, const RegionSamples& samples,
                                 std::span<const RegionMeshPtr> parts, std::array<int, 2> split,
                                 const DecimationParameters& parameters, const std::stop_token& stop) {
    m_patch.load(samples);
    if (!(m_patch.guard(parameters.allowance) <= parameters.allowance / 2))
        return nullptr;
    load(grid, samples.rect, parts);
    m_seeds.clear();
    for (std::size_t v = 0; v < m_vertices.size(); ++v)
        if (m_vertices[v].i == split[0] || m_vertices[v].j == split[1])
            m_seeds.push_back(static_cast<std::int32_t>(v));
    const bool surface = parameters.level == ErrorLevel::surface;
    const IndexRect& rect = samples.rect;
    const std::array<bool, 4> isMapEdge{rect.j0 == 0, rect.j1 == grid.ny(), rect.i0 == 0,
                                        rect.i1 == grid.nx()};
    if (!m_removal.runFrom(m_patch, floatNotAbove(parameters.allowance), surface, m_seeds, isMapEdge, m_mesh,
                           stop))
        return nullptr;
    RegionMesh mesh = regionMeshOf(m_mesh, m_patch, grid, samples.rect, parameters);
    mesh.allowance = parameters.allowance;
    return std::make_shared<const RegionMesh>(std::move(mesh));
}

void RegionMerge::load(const RegionGrid& grid, const IndexRect& rect, std::span<const RegionMeshPtr> parts) {
    m_vertices.clear();
    m_triangles.clear();
    m_vertexAt.assign(static_cast<std::size_t>(rect.width()) * static_cast<std::size_t>(rect.height()), -1);
    const auto nx = static_cast<std::uint32_t>(grid.nx());
    for (const RegionMeshPtr& part : parts) {
        for (const LatticeTriangle& triangle : part->triangles) {
            std::array<std::int32_t, 3> corners{};
            for (std::size_t k = 0; k < corners.size(); ++k)
                corners[k] = vertexAt(static_cast<std::int32_t>(triangle[k] % nx) - rect.i0,
                                      static_cast<std::int32_t>(triangle[k] / nx) - rect.j0);
            m_triangles.push_back(corners);
        }
    }
    m_mesh.assign(m_vertices, m_triangles);
    std::int32_t t = 0;
    for (const RegionMeshPtr& part : parts) {
        const auto distance =
            std::nextafter(static_cast<float>(part->largestError), std::numeric_limits<float>::infinity());
        for (std::size_t k = 0; k < part->triangles.size(); ++k)
            m_mesh.triangle(t++).distance = distance;
    }
}

std::int32_t RegionMerge::vertexAt(std::int32_t i, std::int32_t j) {
    std::int32_t& vertex =
        m_vertexAt[static_cast<std::size_t>(j) * static_cast<std::size_t>(m_patch.width()) +
                   static_cast<std::size_t>(i)];
    if (vertex < 0) {
        vertex = static_cast<std::int32_t>(m_vertices.size());
        m_vertices.push_back({i, j, m_patch.at(i, j)});
    }
    return vertex;
}

} // namespace proveout
