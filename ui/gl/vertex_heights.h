// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/decimation/surface/surface.h"
#include "ui/gl/gl_functions.h"
#include "ui/gl/point_table.h"

namespace proveout {

/// The heights of the vertices of decimated meshes on the GPU: few points, whose triangles are long, so that
/// a height from a coarser map would tilt them. All methods need the same context to be current.
class VertexHeights {
public:
    VertexHeights() = default;
    VertexHeights(const VertexHeights&) = delete;
    VertexHeights& operator=(const VertexHeights&) = delete;

    /// Empty, in at most `bytes`.
    void reset(Gl& gl, std::size_t bytes);
    /// So many tiles have changed since the last call, of so many. Their heights follow through setTile().
    void tilesChanged(std::size_t changed, std::size_t of);
    /// The heights of a tile that has changed.
    void setTile(const ZMapSnapshot& moment, std::size_t index);
    /// Adds the vertices of a surface and uploads what has changed. False if there are too many.
    [[nodiscard]] bool follow(Gl& gl, const SurfaceSnapshot& surface, const ZMapSnapshot& moment);
    /// Removes all vertices, on the GPU too.
    void drop(Gl& gl);
    void release(Gl& gl);

    [[nodiscard]] GLuint id() const { return m_texture; } ///< a GL_TEXTURE_2D of PointTable's entries
    [[nodiscard]] int shift() const { return m_table.shift(); }
    [[nodiscard]] std::size_t bytes() const;

private:
    void forget();
    [[nodiscard]] bool addAll(const SurfaceSnapshot& surface, const ZMapSnapshot& moment);
    void upload(Gl& gl);

    PointTable m_table;
    std::vector<RegionMeshPtr> m_meshes; ///< whose vertices have been added, per region
    GLuint m_texture = 0;
};

} // namespace proveout
