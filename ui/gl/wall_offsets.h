// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/zmap/zmap.h"
#include "ui/gl/gl_functions.h"
#include "ui/gl/shader_program.h"

namespace proveout {

/// How far points beside walls are moved to stand on them, as textures for walls.glsl: one with the place of
/// each tile of the z-map, and one with the points of those tiles that have walls or are next to one. Only
/// what has changed is uploaded. All methods need the same context to be current.
class WallOffsets {
public:
    WallOffsets() = default;
    WallOffsets(const WallOffsets&) = delete;
    WallOffsets& operator=(const WallOffsets&) = delete;

    /// Returns the number of bytes uploaded. Without memory for them, there are no walls.
    std::size_t update(Gl& gl, const ZMapSnapshot& moment);
    /// `used`: false where the surface consists of other points.
    void set(Gl& gl, ShaderProgram& program, bool used) const;
    void release(Gl& gl);
    [[nodiscard]] std::size_t bytes() const;

private:
    struct Uploaded {
        std::shared_ptr<const WallTile> walls;
        std::shared_ptr<const Tile> heights; ///< from which the points were moved
    };

    void restart(Gl& gl, const ZMapSnapshot& moment);
    /// The tiles beside whose points differ from those uploaded, and their neighbours, ascending.
    [[nodiscard]] std::vector<std::size_t> changedTiles(const ZMapSnapshot& moment) const;
    void givePlaces(const std::vector<std::size_t>& tiles);
    [[nodiscard]] bool makeRoom(Gl& gl, std::size_t places);
    [[nodiscard]] std::size_t upload(Gl& gl, const ZMapSnapshot& moment, std::size_t tile);

    GLuint m_places = 0;
    GLuint m_offsets = 0;
    int m_layers = 0;
    Grid m_grid;
    bool m_refused = false;
    bool m_shown = false;
    bool m_isWhole = true;               ///< false: the texture has grown, and nothing is in it
    bool m_placesDue = false;            ///< a tile has got a place since they were uploaded
    std::vector<Uploaded> m_uploaded;    ///< per tile
    std::vector<std::int32_t> m_placeOf; ///< per tile; below 0: none
    std::size_t m_used = 0;
};

} // namespace proveout
