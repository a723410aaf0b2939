// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/decimation/surface/surface.h"
#include "ui/gl/gl_functions.h"
#include "ui/gl/index_buffer.h"

namespace proveout {

/// The upper edge of an outside wall of the stock along one border at the edge of the map, as lattice points
/// from left to right seen from outside. It ends where the next one begins.
struct WallLine {
    Side side = Side::south;
    std::vector<std::uint32_t> points; ///< fewer than two: the previous line continues past this border
};
/// One line per border at the edge. They match the triangles of the surface vertex by vertex, because a
/// merged mesh may have removed points of the borders.
/// `step`: SurfaceBuffer::update().
[[nodiscard]] std::vector<WallLine> wallLines(const SurfaceSnapshot& surface, int step = 1);

/// The outside wall below such a line, and the part of the underside next to it, as indices into the lattice
/// (index + number of points: the point on the floor).
struct WallMesh {
    std::vector<std::uint32_t> wall;
    std::vector<std::uint32_t> underside;
};
[[nodiscard]] WallMesh wallMesh(const RegionGrid& grid, const WallLine& line);

/// All walls and the underside on the GPU; the part below a line is written again only when the line has
/// changed. All methods need the same context to be current.
class WallBuffer {
public:
    /// Sequence of the faces: kSides, then the underside.
    static constexpr std::size_t kFaces = 5;
    static constexpr std::size_t kUnderside = 4;

    /// IndexBuffer::setLimit().
    void setLimit(std::size_t bytes) { m_indices.setLimit(bytes); }
    /// Returns the number of indices uploaded; nothing if the limit is too small.
    [[nodiscard]] std::optional<std::size_t> update(Gl& gl, const SurfaceSnapshot& surface, int step = 1);
    [[nodiscard]] std::size_t bytes() const { return m_indices.bytes(); } ///< held now
    void draw(Gl& gl, std::size_t face);
    void release(Gl& gl);

private:
    struct Piece {
        WallLine line;
        IndexBuffer::Slot slot; ///< the wall's indices, then the underside's
        std::uint32_t wall = 0;
        std::uint32_t underside = 0;
    };
    struct DrawList {
        std::vector<GLsizei> counts;
        std::vector<const void*> offsets;
    };

    /// False if there is no room.
    [[nodiscard]] bool write(Gl& gl, Piece& piece, WallLine line);
    [[nodiscard]] std::optional<std::size_t> writeChanged(Gl& gl, const std::vector<WallLine>& lines);
    void collect();

    RegionGrid m_grid;
    std::vector<Piece> m_pieces;
    IndexBuffer m_indices;
    std::array<DrawList, kFaces> m_lists;
};

} // namespace proveout
