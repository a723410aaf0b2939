// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/vertex_heights.h"

namespace proveout {

void VertexHeights::reset(Gl& gl, std::size_t bytes) {
    m_table.reset(bytes);
    m_meshes.clear();
    if (m_texture == 0)
        gl.glGenTextures(1, &m_texture);
    gl.glBindTexture(GL_TEXTURE_2D, m_texture);
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_RG32UI, PointTable::kRow, static_cast<GLsizei>(m_table.rows()), 0,
                    GL_RG_INTEGER, GL_UNSIGNED_INT, nullptr);
    upload(gl); // a search ends at an empty entry only
}

void VertexHeights::forget() {
    m_table.clear();
    m_meshes.assign(m_meshes.size(), nullptr);
}

void VertexHeights::tilesChanged(std::size_t changed, std::size_t of) {
    constexpr std::size_t kMany = 8; // adding the vertices again is then faster than searching every point
    if (changed > of / kMany)
        forget();
}

void VertexHeights::setTile(const ZMapSnapshot& moment, std::size_t index) {
    if (m_table.empty())
        return;
    const IndexRect rect = moment.tileRect(index);
    const Tile& tile = *moment.tile(index);
    const auto nx = static_cast<std::uint32_t>(moment.grid().nx);
    for (int j = rect.j0; j < rect.j1; ++j)
        for (int i = rect.i0; i < rect.i1; ++i)
            m_table.set(static_cast<std::uint32_t>(j) * nx + static_cast<std::uint32_t>(i),
                        tile.at(i - rect.i0, j - rect.j0));
}

bool VertexHeights::addAll(const SurfaceSnapshot& surface, const ZMapSnapshot& moment) {
    const auto nx = static_cast<std::uint32_t>(moment.grid().nx);
    for (std::size_t region = 0; region < m_meshes.size(); ++region) {
        const RegionMeshPtr& mesh = surface.meshes[region];
        if (mesh == m_meshes[region])
            continue;
        m_meshes[region] = mesh;
        if (mesh == nullptr)
            continue;
        for (const LatticeTriangle& triangle : mesh->triangles)
            for (const std::uint32_t point : triangle)
                if (!m_table.add(point,
                                 moment.height(static_cast<int>(point % nx), static_cast<int>(point / nx))))
                    return false;
    }
    return true;
}

bool VertexHeights::follow(Gl& gl, const SurfaceSnapshot& surface, const ZMapSnapshot& moment) {
    m_meshes.resize(surface.meshes.size());
    bool all = addAll(surface, moment);
    if (!all) { // it may be full of vertices of earlier meshes
        forget();
        all = addAll(surface, moment);
    }
    if (!all)
        forget();
    upload(gl);
    return all;
}

void VertexHeights::drop(Gl& gl) {
    forget();
    upload(gl);
}

void VertexHeights::upload(Gl& gl) {
    gl.glBindTexture(GL_TEXTURE_2D, m_texture);
    for (const std::size_t row : m_table.takeChangedRows())
        gl.glTexSubImage2D(GL_TEXTURE_2D, 0, 0, static_cast<GLint>(row), PointTable::kRow, 1, GL_RG_INTEGER,
                           GL_UNSIGNED_INT, m_table.row(row).data());
}

void VertexHeights::release(Gl& gl) {
    if (m_texture != 0)
        gl.glDeleteTextures(1, &m_texture);
    m_texture = 0;
    m_meshes.clear();
}

std::size_t VertexHeights::bytes() const {
    return m_texture == 0 ? 0 : m_table.rows() * PointTable::kRow * sizeof(PointTable::Entry);
}

} // namespace proveout
