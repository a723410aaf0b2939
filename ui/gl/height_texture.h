// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/zmap/zmap.h"
#include "ui/gl/gl_functions.h"
#include "ui/gl/upload_budget.h"

namespace proveout {

/// The z-map as a texture of one float a point, on the graphics side. Only tiles whose pointer differs from
/// the one that is there are uploaded. All methods need the same context to be current.
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
        bool whole = true; ///< the texture holds the moment
    };

    /// Makes the texture hold `moment`, or comes nearer to it: the next call goes on. The grid must fit.
    Uploaded update(Gl& gl, const ZMapSnapshot& moment, const UploadBudget& budget = {});
    void release(Gl& gl);

    [[nodiscard]] GLuint id() const { return m_texture; }
    /// Whether a point stands on the stock's floor, so that the picture may have holes.
    [[nodiscard]] bool touchesFloor() const { return m_tilesOnFloor > 0; }

private:
    void restart(Gl& gl, const ZMapSnapshot& moment);
    /// Returns its bytes.
    std::size_t upload(Gl& gl, const ZMapSnapshot& moment, std::size_t index);

    GLuint m_texture = 0;
    Grid m_grid;
    float m_floor = 0;
    std::vector<std::shared_ptr<const Tile>> m_tiles; ///< what is there; null: nothing yet
    std::vector<bool> m_onFloor;                      ///< per tile
    std::size_t m_tilesOnFloor = 0;
};

} // namespace proveout
