// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/surface_renderer.h"

#include <algorithm>
#include <array>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>

#include "ui/gl/coarse_points.h"

namespace proveout {
namespace {

constexpr std::array kNormals{glm::vec3(0, -1, 0), glm::vec3(0, 1, 0), glm::vec3(-1, 0, 0),
                              glm::vec3(1, 0, 0), glm::vec3(0, 0, -1)};
constexpr float kTintStrength = 0.65f;
constexpr float kHatchPixels = 8; // logical
} // namespace

SurfaceRenderer::SurfaceRenderer(int mostTexturePoints)
    : m_programs("heights.glsl"), m_mostTexturePoints(mostTexturePoints), m_heights(mostTexturePoints) {}

void SurfaceRenderer::setLimit(std::size_t bytes) {
    if (bytes == m_limit)
        return;
    m_chosen = false;
    m_parts.forgetRefusal();
    m_limit = bytes;
}

void SurfaceRenderer::setMostTextureBytes(std::size_t bytes) {
    m_chosen = m_chosen && bytes == m_mostTextureBytes;
    m_mostTextureBytes = bytes;
}

std::size_t SurfaceRenderer::bytes() const {
    return m_heights.bytes() + m_parts.bytes() + m_surface.bytes() + m_wallBuffer.bytes() +
           m_wallOffsets.bytes() + m_deviations.bytes();
}

bool SurfaceRenderer::fits(Gl& gl, const Grid& grid) const {
    const bool inParts = m_chosen && grid == m_grid && m_partPrograms; // perhaps because of the triangles
    return inParts || m_heights.bytesOf(gl, grid) > mostHeightBytes() ? m_parts.fits(grid)
                                                                      : m_heights.fits(gl, grid);
}

void SurfaceRenderer::choose(Gl& gl, const Grid& grid) {
    if (m_chosen && grid == m_grid)
        return;
    m_chosen = true;
    const std::size_t ofHeights = m_heights.bytesOf(gl, grid);
    const bool whole = ofHeights <= mostHeightBytes();
    const std::size_t ofWalls =
        whole ? std::min((m_limit - ofHeights) / 4, GraphicsShares::mostWallBytes(grid)) : 0;
    const std::size_t ofLists = whole ? m_limit - ofHeights - ofWalls : 0;
    // Buffers of triangles never shrink, and the heights of this grid may take more than those held.
    const bool tooLarge = bytes() > m_limit || m_surface.bytes() > ofLists || m_wallBuffer.bytes() > ofWalls;
    if (!whole || m_partPrograms || tooLarge)
        release(gl);
    m_partPrograms.reset();
    if (!whole) {
        holdParts(gl, grid);
        return;
    }
    m_surface.setLimit(ofLists);
    m_wallBuffer.setLimit(ofWalls);
}

void SurfaceRenderer::holdParts(Gl& gl, const Grid& grid) {
    TextureLimits limits;
    gl.glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limits.side);
    gl.glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &limits.layers);
    limits.side = std::min(limits.side, m_mostTexturePoints);
    limits.bytes = m_mostTextureBytes;
    m_shares = GraphicsShares::of(grid, m_limit, limits);
    m_surface.setLimit(m_shares.lists);
    m_wallBuffer.setLimit(m_shares.walls);
    m_partPrograms.emplace("partial_heights.glsl");
}

UploadCounts SurfaceRenderer::upload(Gl& gl, const Frame& frame, const UploadBudget& budget) {
    choose(gl, frame.zmap.grid());
    m_step = stepFor(frame);
    m_grid = frame.zmap.grid();
    m_floor = frame.zmap.floor();
    m_regionCells = frame.surface.grid.cells();
    if (m_partPrograms)
        return uploadParts(gl, frame, budget);
    UploadCounts counts = uploadWhole(gl, frame, budget);
    if (counts.fits || !m_heights.fits(gl, m_grid))
        return counts;
    release(gl); // there is room for the heights, but not for the triangles too
    holdParts(gl, m_grid);
    return uploadParts(gl, frame, budget);
}

bool SurfaceRenderer::uploadSurface(Gl& gl, const SurfaceSnapshot& surface, const UploadBudget& budget,
                                    UploadCounts& counts, int step) {
    const SurfaceBuffer::Uploaded uploaded = m_surface.update(gl, surface, budget, step);
    counts.lists += uploaded.lists;
    counts.whole = uploaded.whole;
    m_wallsDue = m_wallsDue || uploaded.changed;
    std::optional<std::size_t> ofWalls = 0;
    if (uploaded.fits && uploaded.whole && std::exchange(m_wallsDue, false))
        ofWalls = m_wallBuffer.update(gl, surface, step);
    m_wallsDue = m_wallsDue || !ofWalls;
    counts.indices += uploaded.indices + ofWalls.value_or(0);
    counts.bytes += uploaded.bytes + ofWalls.value_or(0) * sizeof(std::uint32_t);
    return uploaded.fits && ofWalls;
}

UploadCounts SurfaceRenderer::uploadWhole(Gl& gl, const Frame& frame, const UploadBudget& budget) {
    UploadCounts counts;
    const HeightTexture::Uploaded heights = m_heights.update(gl, frame.zmap, budget);
    counts.tiles = heights.tiles;
    counts.bytes = heights.bytes + m_wallOffsets.update(gl, frame.zmap);
    counts.whole = heights.whole;
    counts.fits = heights.fits;
    if (!counts.whole || !counts.fits)
        return counts;
    m_sampled = m_step > 1;
    counts.fits = uploadSurface(gl, m_sampled ? bare(frame.surface) : frame.surface, budget, counts, m_step);
    return counts;
}

UploadCounts SurfaceRenderer::uploadParts(Gl& gl, const Frame& frame, const UploadBudget& budget) {
    UploadCounts counts;
    const HeightTexture::Uploaded heights = m_parts.update(gl, frame.zmap, m_shares, budget);
    counts.tiles = heights.tiles;
    counts.bytes = heights.bytes + m_wallOffsets.update(gl, frame.zmap);
    counts.whole = heights.whole;
    counts.fits = heights.fits && m_partPrograms->valid();
    // The coarser points must be completed before the meshes are tried again, or updates in slices never end.
    m_sampling = m_sampling && heights.tiles == 0;
    if (!counts.whole || !counts.fits)
        return counts;
    m_sampled = m_sampling || !uploadMeshes(gl, frame, budget, counts);
    if (m_sampled)
        counts.fits =
            uploadSurface(gl, bare(frame.surface), budget, counts, std::max(m_shares.coarseStep, m_step));
    m_sampling = m_sampled && counts.fits && !counts.whole;
    return counts;
}

int SurfaceRenderer::stepFor(const Frame& frame) const {
    const bool hadTooMany = m_step > 1 && frame.playing && frame.zmap.grid() == m_grid;
    if (frame.surface.faces <= (hadTooMany ? m_mostTriangles / 2 : m_mostTriangles))
        return 1;
    return std::max(2, stepWithin(frame.surface.grid, m_mostTriangles));
}

bool SurfaceRenderer::uploadMeshes(Gl& gl, const Frame& frame, const UploadBudget& budget,
                                   UploadCounts& counts) {
    if (m_step > 1 || SurfaceBuffer::bytesFor(frame.surface) > m_shares.lists) {
        m_parts.dropVertices(gl);
        return false;
    }
    return m_parts.holdVertices(gl, frame.surface, frame.zmap) &&
           uploadSurface(gl, frame.surface, budget, counts);
}

const SurfaceSnapshot& SurfaceRenderer::bare(const SurfaceSnapshot& surface) {
    if (!(m_bare.grid == surface.grid) || m_bare.meshes.size() != surface.meshes.size()) {
        m_bare.grid = surface.grid;
        m_bare.meshes = PersistentArray<RegionMeshPtr>(surface.meshes.size());
        m_bare.borders = PersistentArray<BorderLinePtr>(surface.borders.size());
    }
    return m_bare;
}

Coarseness SurfaceRenderer::refine(Gl& gl, const Frame& frame, const View& view, const UploadBudget& budget) {
    if (!m_partPrograms)
        return {.coarser = m_sampled, .tooManyTriangles = m_step > 1};
    const Vec3 origin(m_grid.x0, m_grid.y0, frame.zmap.stock().floorZ());
    const bool fromBelow = view.perspective ? view.eye.z < origin.z : view.eye.z < 0;
    const std::vector<VisiblePage> visible =
        visiblePages(m_grid, m_parts.pages(), m_parts.heightsSeen(fromBelow),
                     {view.clipFromWorld * glm::translate(glm::dmat4(1), origin), view.pixels});
    const std::vector<int> pages = pagesToHold(visible, m_shares.coarseStep, m_parts.capacity());
    const bool held = m_parts.hold(gl, frame.zmap, pages, budget);
    return {.coarser = m_sampled || !held || pages.size() < visible.size(),
            .tooManyTriangles = m_step > 1,
            .pending = !held};
}

Colouring SurfaceRenderer::uploadDeviation(Gl& gl, const ZMapSnapshot& moment, const Deviation* deviation,
                                           const PartTolerance& tolerance, const UploadBudget& budget) {
    m_tolerance = tolerance;
    if (deviation == nullptr) {
        m_deviations.release(gl);
        return Colouring::none;
    }
    if (!deviation->isOn(moment))
        return Colouring::none;
    const HeightPages& pages = m_heights.pages();
    const std::size_t more = m_deviations.bytes() == 0 ? DeviationTexture::bytesOf(pages) : 0;
    if (m_partPrograms || bytes() + more > m_limit) {
        m_deviations.release(gl);
        return Colouring::tooLarge;
    }
    if (!m_colouredPrograms)
        m_colouredPrograms.emplace("heights.glsl", true);
    const DeviationTexture::Uploaded uploaded = m_deviations.update(gl, moment, *deviation, pages, budget);
    if (!uploaded.fits || !m_colouredPrograms->valid())
        return Colouring::tooLarge;
    return uploaded.whole ? Colouring::whole : Colouring::pending;
}

void SurfaceRenderer::setStock(Gl& gl, ShaderProgram& program, const SceneOptions& options) {
    if (m_partPrograms) {
        m_parts.set(gl, program);
    } else {
        const HeightPages& pages = m_heights.pages();
        program.set(gl, "heights", 0);
        program.set(gl, "pagePoints", pages.points);
        program.set(gl, "pageColumns", pages.columns);
        program.set(gl, "pageMargin", pages.margin);
    }
    m_wallOffsets.set(gl, program, !m_sampled);
    program.set(gl, "gridPoints", glm::ivec2(m_grid.nx, m_grid.ny));
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
    const bool floor = m_partPrograms ? m_parts.touchesFloor() : m_heights.touchesFloor();
    ShaderProgram& program = options.wireframe                  ? programs().wire
                             : floor || m_cutOut.x < m_cutOut.z ? programs().holes
                                                                : programs().plain;
    program.bind(gl);
    setView(gl, program, view);
    setStock(gl, program, options);
    program.set(gl, "regionCells", static_cast<float>(m_regionCells));
    program.set(gl, "wireColour", options.colours.wire);
    program.set(gl, "regionColour", options.colours.regionLine);
    program.set(gl, "lineWidth", view.pixelRatio);
    const float strength = options.tint && !m_sampled ? kTintStrength : 0.0f; // no mesh is drawn then
    if (m_isColoured)
        m_deviations.set(gl, program, options.colours.deviation, m_tolerance);
    program.set(gl, "hatchPixels", kHatchPixels * view.pixelRatio);
    program.set(gl, "tint", glm::vec4(options.colours.dirty, strength));
    m_surface.draw(gl, SurfaceBuffer::Part::fromZMap);
    program.set(gl, "tint", glm::vec4(options.colours.decimated, strength));
    m_surface.draw(gl, SurfaceBuffer::Part::decimated);
}

void SurfaceRenderer::drawWalls(Gl& gl, const StockView& view, const SceneOptions& options) {
    ShaderProgram& program = programs().walls;
    program.bind(gl);
    setView(gl, program, view);
    setStock(gl, program, options);
    for (std::size_t face = 0; face < WallBuffer::kFaces; ++face) {
        program.set(gl, "normal", kNormals[face]);
        program.set(gl, "underside", face == WallBuffer::kUnderside);
        m_wallBuffer.draw(gl, face);
    }
}

void SurfaceRenderer::draw(Gl& gl, const StockView& view, const SceneOptions& options,
                           const ZMapSnapshot& moment) {
    m_isColoured = options.deviation && !m_partPrograms && m_colouredPrograms &&
                   m_colouredPrograms->valid() && m_deviations.select(gl, moment);
    gl.glActiveTexture(GL_TEXTURE0);
    gl.glBindTexture(GL_TEXTURE_2D_ARRAY, m_heights.id());
    drawTop(gl, view, options);
    drawWalls(gl, view, options);
}

void SurfaceRenderer::release(Gl& gl) {
    m_heights.release(gl);
    m_deviations.release(gl);
    m_parts.release(gl);
    m_surface.release(gl);
    m_wallBuffer.release(gl);
    m_wallOffsets.release(gl);
    m_wallsDue = true;
    m_sampled = m_sampling = false;
}

} // namespace proveout
