// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>

#include "core/simulation/run/frame.h"
#include "ui/gl/deviation_texture.h"
#include "ui/gl/height_texture.h"
#include "ui/gl/partial_heights.h"
#include "ui/gl/scene_light.h"
#include "ui/gl/scene_options.h"
#include "ui/gl/surface_buffer.h"
#include "ui/gl/surface_programs.h"
#include "ui/gl/visible_pages.h"
#include "ui/gl/wall_buffer.h"
#include "ui/gl/wall_offsets.h"

namespace proveout {

/// What was uploaded for one frame.
struct UploadCounts {
    std::size_t tiles = 0;
    std::size_t lists = 0;   ///< triangle lists of regions, including shared patterns
    std::size_t indices = 0; ///< in these lists and in the walls
    std::size_t bytes = 0;   ///< heights and indices
    bool whole = true;       ///< whether the frame is uploaded completely
    bool fits = true;        ///< false: the driver has no memory for it, or it is allowed too little
};

/// What a picture lacks.
struct Coarseness {
    bool coarser = false;          ///< not every point of the grid in the view is used
    bool tooManyTriangles = false; ///< because the surface has more triangles than are drawn
    bool pending = false;          ///< another call makes it finer
};

/// Whether the stock can be coloured by its deviation from the part.
enum class Colouring : std::uint8_t { none, pending, whole, tooLarge };

/// Draws the stock: top surface, walls, underside. Its heights and triangles take no more bytes on the GPU
/// than allowed: where all heights do not fit, or not in one texture, the stock is drawn from coarser points,
/// with exact vertices of the decimated meshes, and from all points in the view if these fit
/// (PartialHeights). If the meshes do not fit either, or there are more triangles than allowed, the surface
/// consists of the coarser points. All methods need the same context to be current.
class SurfaceRenderer {
public:
    /// `mostTexturePoints`: HeightTexture.
    explicit SurfaceRenderer(int mostTexturePoints);

    [[nodiscard]] bool valid() const { return m_programs.valid(); }
    /// The bytes that are allowed from the next upload on; without a call, any number.
    void setLimit(std::size_t bytes);
    /// The bytes of one texture of heights, which is created in one piece; without a call, any number. Where
    /// all heights take more, they are not all held.
    void setMostTextureBytes(std::size_t bytes);
    /// The triangles that are drawn at most, as long as a region has at least two; without a call, any
    /// number.
    void setMostTriangles(std::size_t triangles) { m_mostTriangles = triangles; }
    /// The bytes of heights and triangles that are held now.
    [[nodiscard]] std::size_t bytes() const;
    /// Whether the driver can hold the heights of that many points, all or in parts.
    [[nodiscard]] bool fits(Gl& gl, const Grid& grid) const;
    /// The grid must fit. If the budget is too small, the next call continues; do not
    /// draw before the frame is complete.
    [[nodiscard]] UploadCounts upload(Gl& gl, const Frame& frame, const UploadBudget& budget = {});
    /// Loads the points that a view of the uploaded frame needs, as far as the budget allows. Nothing to do
    /// where all heights are held.
    [[nodiscard]] Coarseness refine(Gl& gl, const Frame& frame, const View& view,
                                    const UploadBudget& budget = {});
    /// A rectangle in plan, in stock coordinates (x, y, x, y), in which nothing is drawn except a pixel at
    /// its rim; empty: none. If it reaches the edge of the stock, its side there must be beyond that edge.
    void setCutOut(const glm::vec4& rectangle) { m_cutOut = rectangle; }
    /// Uploads deviations as far as the budget allows; those of other heights than `moment`, the uploaded
    /// one, has are not drawn. Null: none. They take only memory that heights and triangles leave.
    Colouring uploadDeviation(Gl& gl, const ZMapSnapshot& moment, const Deviation* deviation,
                              const PartTolerance& tolerance, const UploadBudget& budget = {});
    /// `moment`: the uploaded one.
    void draw(Gl& gl, const StockView& view, const SceneOptions& options, const ZMapSnapshot& moment);
    void release(Gl& gl);
    [[nodiscard]] std::size_t triangles(SurfaceBuffer::Part part) const { return m_surface.triangles(part); }

private:
    /// Whether all heights are to be held, decided for each grid and limit.
    void choose(Gl& gl, const Grid& grid);
    [[nodiscard]] std::size_t mostHeightBytes() const { return std::min(m_limit, m_mostTextureBytes); }
    void holdParts(Gl& gl, const Grid& grid);
    [[nodiscard]] UploadCounts uploadWhole(Gl& gl, const Frame& frame, const UploadBudget& budget);
    [[nodiscard]] UploadCounts uploadParts(Gl& gl, const Frame& frame, const UploadBudget& budget);
    /// The step between the points at which a surface has few enough triangles; 1: as it is. While a program
    /// is played, its number of triangles rises and falls with every decimation; so that the picture does not
    /// change with it, a surface that had too many is drawn as it is only once it has far fewer.
    [[nodiscard]] int stepFor(const Frame& frame) const;
    /// Uploads the meshes and the heights of their vertices. False if they do not fit.
    [[nodiscard]] bool uploadMeshes(Gl& gl, const Frame& frame, const UploadBudget& budget,
                                    UploadCounts& counts);
    [[nodiscard]] bool uploadSurface(Gl& gl, const SurfaceSnapshot& surface, const UploadBudget& budget,
                                     UploadCounts& counts, int step = 1);
    /// The surface of these regions with no mesh.
    [[nodiscard]] const SurfaceSnapshot& bare(const SurfaceSnapshot& surface);
    [[nodiscard]] SurfacePrograms& programs() {
        return m_isColoured ? *m_colouredPrograms : m_partPrograms ? *m_partPrograms : m_programs;
    }
    void setStock(Gl& gl, ShaderProgram& program, const SceneOptions& options);
    void drawTop(Gl& gl, const StockView& view, const SceneOptions& options);
    void drawWalls(Gl& gl, const StockView& view, const SceneOptions& options);

    SurfacePrograms m_programs;
    std::optional<SurfacePrograms> m_partPrograms;     ///< empty while all heights are held
    std::optional<SurfacePrograms> m_colouredPrograms; ///< empty while no deviation has been uploaded
    std::size_t m_limit = std::numeric_limits<std::size_t>::max();
    std::size_t m_mostTextureBytes = std::numeric_limits<std::size_t>::max();
    std::size_t m_mostTriangles = std::numeric_limits<std::size_t>::max();
    bool m_chosen = false;
    PartialHeights m_parts;
    GraphicsShares m_shares;
    SurfaceSnapshot m_bare;
    bool m_sampled = false;  ///< the surface consists of the coarser points
    bool m_sampling = false; ///< and it is not complete yet
    int m_step = 1;          ///< more than 1: because of its triangles
    int m_mostTexturePoints;
    HeightTexture m_heights;
    SurfaceBuffer m_surface;
    WallBuffer m_wallBuffer;
    WallOffsets m_wallOffsets;
    DeviationTexture m_deviations;
    PartTolerance m_tolerance;
    bool m_isColoured = false; ///< in the picture that is being drawn
    bool m_wallsDue = true;    ///< the surface has changed since the walls were written
    Grid m_grid;
    float m_floor = -1;
    int m_regionCells = 1;
    glm::vec4 m_cutOut{1, 1, -1, -1};
};

} // namespace proveout
