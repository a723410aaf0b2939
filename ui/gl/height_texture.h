// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/zmap/zmap.h"
#include "ui/gl/gl_functions.h"
#include "ui/gl/upload_budget.h"

namespace proveout {

/// The z-map as a texture on the GPU with one float per point. Only tiles whose pointer has changed are
/// uploaded. All methods need the same context to be current.
class HeightTexture {
public:
    HeightTexture() = default;
    HeightTexture(const HeightTexture&) = delete;
    HeightTexture& operator=(const HeightTexture&) = delete;

    /// Whether the driver accepts a texture with that many points.
    [[nodiscard]] static bool fits(Gl& gl, const Grid& grid);

    struct Uploaded {
        std::size_t tiles = 0;
        std::size_t bytes = 0;
        bool whole = true; ///< whether the texture shows the moment completely
    };

    /// Uploads `moment`, or a part of it if the budget is too small; the next call continues. The grid must
    /// fit.
    Uploaded update(Gl& gl, const ZMapSnapshot& moment, const UploadBudget& budget = {});
    void release(Gl& gl);

    [[nodiscard]] GLuint id() const { return m_texture; }
    /// Whether any point is on the floor of the stock, so that the surface may have holes.
    [[nodiscard]] bool touchesFloor() const { return m_tilesOnFloor > 0; }

private:
    void restart(Gl& gl, const ZMapSnapshot& moment);
    /// Returns the number of bytes uploaded.
    std::size_t upload(Gl& gl, const ZMapSnapshot& moment, std::size_t index);

    GLuint m_texture = 0;
    Grid m_grid;
    float m_floor = 0;
    std::vector<std::shared_ptr<const Tile>> m_tiles; ///< the uploaded tiles; null: not uploaded yet
    std::vector<bool> m_onFloor;                      ///< per tile
    std::size_t m_tilesOnFloor = 0;
};

} // namespace proveout
