// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/surface_renderer.h"

#include <array>
#include <utility>

namespace proveout {
namespace {

constexpr std::array kNormals{glm::vec3(0, -1, 0), glm::vec3(0, 1, 0), glm::vec3(-1, 0, 0),
                              glm::vec3(1, 0, 0), glm::vec3(0, 0, -1)};
constexpr float kTintStrength = 0.65f;
const QList<const char*> kVertex{"heights.glsl", "surface.vert"};

} // namespace

SurfaceRenderer::SurfaceRenderer(int mostTexturePoints)
    : m_plain({kVertex, nullptr, {"heights.glsl", "lighting.glsl", "surface.frag"}, {}}),
      m_holes(
          {kVertex, nullptr, {"cut_out.glsl", "heights.glsl", "lighting.glsl", "surface.frag"}, {"HOLES"}}),
      m_wire({kVertex,
              "wireframe.geom",
              {"cut_out.glsl", "heights.glsl", "lighting.glsl", "surface.frag"},
              {"HOLES", "WIREFRAME"}}),
      m_walls({kVertex, nullptr, {"cut_out.glsl", "heights.glsl", "lighting.glsl", "wall.frag"}, {}}),
      m_heights(mostTexturePoints) {}

bool SurfaceRenderer::valid() const {
    return m_plain.valid() && m_holes.valid() && m_wire.valid() && m_walls.valid();
}

UploadCounts SurfaceRenderer::upload(Gl& gl, const Frame& frame, const UploadBudget& budget) {
    m_grid = frame.zmap.grid();
    m_floor = frame.zmap.floor();
    m_regionCells = frame.surface.grid.cells();
    UploadCounts counts;
    const HeightTexture::Uploaded heights = m_heights.update(gl, frame.zmap, budget);
    counts.tiles = heights.tiles;
    counts.bytes = heights.bytes;
    counts.whole = heights.whole;
    counts.fits = heights.fits;
    if (!counts.whole || !counts.fits)
        return counts;
    const SurfaceBuffer::Uploaded uploaded = m_surface.update(gl, frame.surface, budget);
    counts.lists = uploaded.lists;
    counts.whole = uploaded.whole;
    m_wallsDue = m_wallsDue || uploaded.changed;
    std::size_t ofWalls = 0;
    if (counts.whole && std::exchange(m_wallsDue, false))
        ofWalls = m_wallBuffer.update(gl, frame.surface);
    counts.indices = uploaded.indices + ofWalls;
    counts.bytes += uploaded.bytes + ofWalls * sizeof(std::uint32_t);
    return counts;
}

void SurfaceRenderer::setStock(Gl& gl, ShaderProgram& program, const SceneOptions& options) {
    const HeightPages& pages = m_heights.pages();
    program.set(gl, "heights", 0);
    program.set(gl, "gridPoints", glm::ivec2(m_grid.nx, m_grid.ny));
    program.set(gl, "pagePoints", pages.points);
    program.set(gl, "pageColumns", pages.columns);
    program.set(gl, "pageMargin", pages.margin);
    program.set(gl, "columns", m_grid.nx);
    program.set(gl, "points", m_grid.nx * m_grid.ny);
    program.set(gl, "spacing", glm::vec2(m_grid.hx, m_grid.hy));
    program.set(gl, "gridSize", glm::vec2(m_grid.nx, m_grid.ny));
    program.set(gl, "floorHeight", m_floor);
    program.set(gl, "stockHeight", -m_floor);
    program.set(gl, "cutOut", m_cutOut);
    program.set(gl, "rawAlbedo", options.colours.rawStock);
    program.set(gl, "cutAlbedo", options.colours.cutStock);
}

void SurfaceRenderer::drawTop(Gl& gl, const StockView& view, const SceneOptions& options) {
    ShaderProgram& program = options.wireframe                                     ? m_wire
                             : m_heights.touchesFloor() || m_cutOut.x < m_cutOut.z ? m_holes
                                                                                   : m_plain;
    program.bind(gl);
    setView(gl, program, view);
    setStock(gl, program, options);
    program.set(gl, "regionCells", static_cast<float>(m_regionCells));
    program.set(gl, "wireColour", options.colours.wire);
    program.set(gl, "regionColour", options.colours.regionLine);
    program.set(gl, "lineWidth", view.pixelRatio);
    const float strength = options.tint ? kTintStrength : 0.0f;
    program.set(gl, "tint", glm::vec4(options.colours.dirty, strength));
    m_surface.draw(gl, SurfaceBuffer::Part::fromZMap);
    program.set(gl, "tint", glm::vec4(options.colours.decimated, strength));
    m_surface.draw(gl, SurfaceBuffer::Part::decimated);
}

void SurfaceRenderer::drawWalls(Gl& gl, const StockView& view, const SceneOptions& options) {
    m_walls.bind(gl);
    setView(gl, m_walls, view);
    setStock(gl, m_walls, options);
    for (std::size_t face = 0; face < WallBuffer::kFaces; ++face) {
        m_walls.set(gl, "normal", kNormals[face]);
        m_walls.set(gl, "underside", face == WallBuffer::kUnderside);
        m_wallBuffer.draw(gl, face);
    }
}

void SurfaceRenderer::draw(Gl& gl, const StockView& view, const SceneOptions& options) {
    gl.glActiveTexture(GL_TEXTURE0);
    gl.glBindTexture(GL_TEXTURE_2D_ARRAY, m_heights.id());
    drawTop(gl, view, options);
    drawWalls(gl, view, options);
}

void SurfaceRenderer::release(Gl& gl) {
    m_heights.release(gl);
    m_surface.release(gl);
    m_wallBuffer.release(gl);
    m_wallsDue = true;
}

} // namespace proveout
