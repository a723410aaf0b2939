// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/decimation/surface.h"
#include "ui/gl/gl_functions.h"
#include "ui/gl/index_buffer.h"

namespace proveout {

/// A border of a region at the edge of the map.
struct EdgeBorder {
    Side side = Side::south;
    std::size_t border = 0; ///< of the grid
};
[[nodiscard]] std::vector<EdgeBorder> edgeBorders(const RegionGrid& grid);

/// The outside wall of the stock below such a border, and the part of the underside that it bounds, as
/// indices into the lattice (index + number of points: the point on the floor). Walls hang from the same
/// border polylines as the surface, so that nothing shows between them.
struct WallMesh {
    std::vector<std::uint32_t> wall;
    std::vector<std::uint32_t> underside;
};
[[nodiscard]] WallMesh wallMesh(const SurfaceSnapshot& surface, const EdgeBorder& edge);

/// All walls and the underside on the graphics side; below a border they are written again when its line is
/// another one. All methods need the same context to be current.
class WallBuffer {
public:
    /// Order of the faces: kSides, then the underside.
    static constexpr std::size_t kFaces = 5;
    static constexpr std::size_t kUnderside = 4;

    /// Returns how many indices went up.
    [[nodiscard]] std::size_t update(Gl& gl, const SurfaceSnapshot& surface);
    void draw(Gl& gl, std::size_t face);
    void release(Gl& gl);

private:
    struct Piece {
        EdgeBorder edge;
        BorderLinePtr line;
        IndexBuffer::Slot slot; ///< the wall's indices, then the underside's
        std::uint32_t wall = 0;
        std::uint32_t underside = 0;
    };
    struct DrawList {
        std::vector<GLsizei> counts;
        std::vector<const void*> offsets;
    };

    void restart(const RegionGrid& grid);
    void write(Gl& gl, Piece& piece, const SurfaceSnapshot& surface);
    void collect();

    RegionGrid m_grid;
    std::vector<Piece> m_pieces;
    IndexBuffer m_indices;
    std::array<DrawList, kFaces> m_lists;
};

} // namespace proveout
