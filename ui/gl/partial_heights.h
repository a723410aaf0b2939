// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "ui/gl/coarse_points.h"
#include "ui/gl/graphics_shares.h"
#include "ui/gl/height_texture.h"
#include "ui/gl/page_residency.h"
#include "ui/gl/shader_program.h"
#include "ui/gl/vertex_heights.h"
#include "ui/gl/visible_pages.h"

namespace proveout {

/// A z-map on the GPU in less memory than its heights take: every step-th point everywhere, the vertices of
/// decimated meshes, and all points of some pages (resources/shaders/partial_heights.glsl). All methods need
/// the same context to be current.
class PartialHeights {
public:
    PartialHeights() = default;
    PartialHeights(const PartialHeights&) = delete;
    PartialHeights& operator=(const PartialHeights&) = delete;

    /// False for the last grid that the driver had no memory for, and one with too many points to count.
    [[nodiscard]] bool fits(const Grid& grid) const {
        return HeightTexture::isCounted(grid) && !(m_refused == grid);
    }
    /// The driver may have memory for other shares.
    void forgetRefusal() { m_refused.reset(); }
    /// Uploads the coarser points of `moment` and what has changed in the pages held, or a part of that if
    /// the budget is too small; the next call continues. `shares` counts only when grid or floor are new, or
    /// after release(). Textures are created one after the other, each in one piece.
    HeightTexture::Uploaded update(Gl& gl, const ZMapSnapshot& moment, const GraphicsShares& shares,
                                   const UploadBudget& budget);
    /// The heights of the vertices of these meshes are exact from now on. False if they are too many; then
    /// those of none are.
    [[nodiscard]] bool holdVertices(Gl& gl, const SurfaceSnapshot& surface, const ZMapSnapshot& moment) {
        return m_vertices.follow(gl, surface, moment);
    }
    /// The heights of no vertices are exact from now on. Either this or holdVertices() follows each complete
    /// update: heights of vertices must not be older than the others.
    void dropVertices(Gl& gl) { m_vertices.drop(gl); }
    /// Loads pages of the uploaded moment, as many as the budget allows; the next call continues. Returns
    /// whether all of them are held.
    bool hold(Gl& gl, const ZMapSnapshot& moment, std::span<const int> pages, const UploadBudget& budget);
    /// Sets textures and uniforms of the bound program.
    void set(Gl& gl, ShaderProgram& program) const;
    void release(Gl& gl);

    [[nodiscard]] const HeightPages& pages() const { return m_pages; }
    [[nodiscard]] std::size_t capacity() const { return m_residency.capacity(); }
    [[nodiscard]] bool holds(int page) const { return m_residency.holds(page); }
    [[nodiscard]] int coarseStep() const { return m_points.step; }
    /// Per page, of what can be seen: from below, or at the edge of the map, that is all of the stock.
    [[nodiscard]] std::vector<PageHeights> heightsSeen(bool fromBelow) const;
    [[nodiscard]] bool touchesFloor() const { return m_tiles.touchesFloor(); }
    [[nodiscard]] std::size_t bytes() const; ///< held now

private:
    void restart(Gl& gl, const ZMapSnapshot& moment, const GraphicsShares& shares);
    /// Creates the textures that each picture needs, or some of them if the budget is too small. False if the
    /// driver has no memory for them.
    [[nodiscard]] bool make(Gl& gl, const UploadBudget& budget);
    void makeCoarse(Gl& gl);
    void makeLayers(Gl& gl);
    /// Without memory for them, no page is held.
    void makePages(Gl& gl);
    [[nodiscard]] std::size_t countChanged(const ZMapSnapshot& moment) const;
    /// Both return the number of bytes uploaded.
    std::size_t uploadCoarse(Gl& gl, const ZMapSnapshot& moment, std::size_t tile);
    std::size_t uploadToPages(Gl& gl, const ZMapSnapshot& moment, std::size_t tile);
    std::size_t uploadPart(Gl& gl, const ZMapSnapshot& moment, std::size_t tile, int page);
    void load(Gl& gl, const ZMapSnapshot& moment, const PageResidency::Load& load);
    [[nodiscard]] bool isAtEdge(int column, int row) const;
    /// The tiles with points that a page holds, as columns and rows.
    [[nodiscard]] IndexRect tilesOf(int column, int row) const;
    void setLayer(Gl& gl, int page, int layer);

    Grid m_grid;
    std::optional<Grid> m_refused; ///< the driver had no memory for it
    float m_floor = 0;
    bool m_made = false; ///< all textures that each picture needs
    std::size_t m_vertexBytes = 0;
    CoarsePoints m_points;
    HeightPages m_pages;
    PageResidency m_residency;
    TileRecord m_tiles;
    VertexHeights m_vertices;
    GLuint m_coarse = 0;
    GLuint m_held = 0;   ///< the pages, a GL_TEXTURE_2D_ARRAY; created when the first one is needed
    GLuint m_layers = 0; ///< of each page
};

} // namespace proveout
