// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "core/zmap/zmap.h"
#include "ui/gl/gl_functions.h"
#include "ui/gl/height_pages.h"
#include "ui/gl/tile_record.h"
#include "ui/gl/upload_budget.h"

namespace proveout {

/// The z-map as a texture on the GPU with one float per point, in pages if it has more points along a side
/// than the driver supports. Only tiles whose pointer has changed are uploaded. All methods need the same
/// context to be current.
class HeightTexture {
public:
    /// Pages have at most `mostPoints` along a side, fewer if the driver demands it.
    explicit HeightTexture(int mostPoints) : m_mostPoints(mostPoints) {}
    HeightTexture(const HeightTexture&) = delete;
    HeightTexture& operator=(const HeightTexture&) = delete;

    /// Whether shaders can count the points of a grid.
    [[nodiscard]] static bool isCounted(const Grid& grid);
    /// Whether the driver accepts that many pages; false too for the last grid that it had no memory for.
    [[nodiscard]] bool fits(Gl& gl, const Grid& grid) const;

    struct Uploaded {
        std::size_t tiles = 0;
        std::size_t bytes = 0;
        bool whole = true; ///< whether the texture shows the moment completely
        bool fits = true;  ///< false: the driver has no memory for it, and nothing was uploaded
    };

    /// Uploads `moment`, or a part of it if the budget is too small; the next call continues. The grid must
    /// fit.
    Uploaded update(Gl& gl, const ZMapSnapshot& moment, const UploadBudget& budget = {});
    void release(Gl& gl);

    [[nodiscard]] GLuint id() const { return m_texture; } ///< a GL_TEXTURE_2D_ARRAY
    [[nodiscard]] const HeightPages& pages() const { return m_pages; }
    /// Whether any point is on the floor of the stock, so that the surface may have holes.
    [[nodiscard]] bool touchesFloor() const { return m_tiles.touchesFloor(); }
    /// The bytes that all heights of a grid take.
    [[nodiscard]] std::size_t bytesOf(Gl& gl, const Grid& grid) const;
    [[nodiscard]] std::size_t bytes() const { return m_texture == 0 ? 0 : m_pages.bytes(); } ///< held now

private:
    [[nodiscard]] HeightPages pagesOf(Gl& gl, const Grid& grid) const;
    /// False if the driver has no memory for it.
    bool restart(Gl& gl, const ZMapSnapshot& moment);
    /// Points of pages that are not in the grid: interpolation must not meet whatever was in that memory.
    void clearOutside(Gl& gl);
    /// Frees what it has of a grid that does not fit.
    [[nodiscard]] Uploaded refuse(Gl& gl);

    int m_mostPoints;
    GLuint m_texture = 0;
    HeightPages m_pages;
    Grid m_grid;
    std::optional<Grid> m_refused; ///< the driver had no memory for it
    bool m_untried = true;         ///< drivers may take the memory at the first upload only
    float m_floor = 0;
    TileRecord m_tiles;
};

} // namespace proveout
