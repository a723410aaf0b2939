// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/run/frame.h"
#include "ui/gl/height_texture.h"
#include "ui/gl/scene_light.h"
#include "ui/gl/scene_options.h"
#include "ui/gl/surface_buffer.h"
#include "ui/gl/wall_buffer.h"

namespace proveout {

/// What went to the graphics side for one frame.
struct UploadCounts {
    std::size_t tiles = 0;
    std::size_t lists = 0;   ///< lists of triangles of regions, shared patterns included
    std::size_t indices = 0; ///< of those lists and of the walls
    std::size_t bytes = 0;   ///< heights and indices
    bool whole = true;       ///< all of the frame is there
};

/// Draws the stock: top surface, walls, underside. All methods need the same context to be current.
class SurfaceRenderer {
public:
    SurfaceRenderer();

    [[nodiscard]] bool valid() const;
    /// The grid must fit (HeightTexture::fits). Where the budget does not do, the next call goes on, and
    /// nothing may be drawn before the frame is whole.
    [[nodiscard]] UploadCounts upload(Gl& gl, const Frame& frame, const UploadBudget& budget = {});
    /// A rectangle in plan, stock coordinates (x, y, x, y), that is left out of the picture but for a pixel
    /// at its rim; none where it is empty. A side at the edge of the stock must be beyond it.
    void setCutOut(const glm::vec4& rectangle) { m_cutOut = rectangle; }
    void draw(Gl& gl, const StockView& view, const SceneOptions& options);
    void release(Gl& gl);
    [[nodiscard]] std::size_t triangles(SurfaceBuffer::Part part) const { return m_surface.triangles(part); }

private:
    void setStock(Gl& gl, ShaderProgram& program, const SceneOptions& options);
    void drawTop(Gl& gl, const StockView& view, const SceneOptions& options);
    void drawWalls(Gl& gl, const StockView& view, const SceneOptions& options);

    // The plain program tests no fragment for holes, so that hidden ones are dropped before they are shaded.
    ShaderProgram m_plain;
    ShaderProgram m_holes;
    ShaderProgram m_wire;
    ShaderProgram m_walls;
    HeightTexture m_heights;
    SurfaceBuffer m_surface;
    WallBuffer m_wallBuffer;
    bool m_wallsDue = true; ///< the surface is another one than theirs
    Grid m_grid;
    float m_floor = -1;
    int m_regionCells = 1;
    glm::vec4 m_cutOut{1, 1, -1, -1};
};

} // namespace proveout
