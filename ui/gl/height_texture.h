// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core/zmap/zmap.h"
#include "ui/gl/gl_functions.h"

namespace proveout {

/// The z-map as a texture of one float a point, on the graphics side. Only tiles whose pointer differs from
/// the moment before are uploaded. All methods need the same context to be current.
class HeightTexture {
public:
    HeightTexture() = default;
    HeightTexture(const HeightTexture&) = delete;
    HeightTexture& operator=(const HeightTexture&) = delete;

    /// Whether the driver takes a texture of that many points.
    [[nodiscard]] static bool fits(Gl& gl, const Grid& grid);

    struct Uploaded {
        std::size_t tiles = 0;
        std::size_t bytes = 0;
    };

    /// Makes the texture hold `moment`. The grid must fit.
    Uploaded update(Gl& gl, const ZMapSnapshot& moment);
    void release(Gl& gl);

    [[nodiscard]] GLuint id() const { return m_texture; }
    /// Whether a point stands on the stock's floor, so that the picture may have holes.
    [[nodiscard]] bool touchesFloor() const { return m_tilesOnFloor > 0; }

private:
    void allocate(Gl& gl, const Grid& grid);
    /// Returns its bytes.
    std::size_t upload(Gl& gl, const ZMapSnapshot& moment, std::size_t index);

    GLuint m_texture = 0;
    ZMapSnapshot m_moment;
    std::vector<bool> m_onFloor; ///< per tile
    std::size_t m_tilesOnFloor = 0;
};

} // namespace proveout
