// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/run/frame.h"
#include "ui/gl/height_texture.h"
#include "ui/gl/scene_light.h"
#include "ui/gl/scene_options.h"
#include "ui/gl/surface_buffer.h"
#include "ui/gl/wall_buffer.h"

namespace proveout {

/// What was uploaded for one frame.
struct UploadCounts {
    std::size_t tiles = 0;
    std::size_t lists = 0;   ///< triangle lists of regions, including shared patterns
    std::size_t indices = 0; ///< in these lists and in the walls
    std::size_t bytes = 0;   ///< heights and indices
    bool whole = true;       ///< whether the frame is uploaded completely
    bool fits = true;        ///< false: the driver has no memory for the heights
};

/// Draws the stock: top surface, walls, underside. All methods need the same context to be current.
class SurfaceRenderer {
public:
    /// `mostTexturePoints`: HeightTexture.
    explicit SurfaceRenderer(int mostTexturePoints);

    [[nodiscard]] bool valid() const;
    /// Whether the driver can hold the heights of that many points.
    [[nodiscard]] bool fits(Gl& gl, const Grid& grid) const { return m_heights.fits(gl, grid); }
    /// The grid must fit. If the budget is too small, the next call continues; do not
    /// draw before the frame is complete.
    [[nodiscard]] UploadCounts upload(Gl& gl, const Frame& frame, const UploadBudget& budget = {});
    /// A rectangle in plan, in stock coordinates (x, y, x, y), in which nothing is drawn except a pixel at
    /// its rim; empty: none. If it reaches the edge of the stock, its side there must be beyond that edge.
    void setCutOut(const glm::vec4& rectangle) { m_cutOut = rectangle; }
    void draw(Gl& gl, const StockView& view, const SceneOptions& options);
    void release(Gl& gl);
    [[nodiscard]] std::size_t triangles(SurfaceBuffer::Part part) const { return m_surface.triangles(part); }

private:
    void setStock(Gl& gl, ShaderProgram& program, const SceneOptions& options);
    void drawTop(Gl& gl, const StockView& view, const SceneOptions& options);
    void drawWalls(Gl& gl, const StockView& view, const SceneOptions& options);

    // This program has no hole test in its fragment shader, so hidden fragments are dropped before shading.
    ShaderProgram m_plain;
    ShaderProgram m_holes;
    ShaderProgram m_wire;
    ShaderProgram m_walls;
    HeightTexture m_heights;
    SurfaceBuffer m_surface;
    WallBuffer m_wallBuffer;
    bool m_wallsDue = true; ///< the surface has changed since the walls were written
    Grid m_grid;
    float m_floor = -1;
    int m_regionCells = 1;
    glm::vec4 m_cutOut{1, 1, -1, -1};
};

} // namespace proveout
