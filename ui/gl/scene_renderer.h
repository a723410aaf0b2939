// SPDX-License-Identifier: GPL-3.0-or-later
// Draws a frame of a simulation with OpenGL 3.3 into the bound framebuffer. Independent of widgets, so that
// the window, studies and tests draw the same image.
#pragma once

#include <limits>
#include <memory>

#include "ui/gl/box_frame.h"
#include "ui/gl/cutter_renderer.h"
#include "ui/gl/fixture_renderer.h"
#include "ui/gl/part_renderer.h"
#include "ui/gl/path_renderer.h"
#include "ui/gl/surface_renderer.h"

namespace proveout {

/// Construction, release() and all methods need the same context to be current.
class SceneRenderer {
public:
    /// Null if OpenGL 3.3 is not available or a shader fails to compile. Textures have at most
    /// `mostTexturePoints` along a side, fewer if the driver demands it.
    [[nodiscard]] static std::unique_ptr<SceneRenderer>
    create(int mostTexturePoints = std::numeric_limits<int>::max());
    SceneRenderer(const SceneRenderer&) = delete;
    SceneRenderer& operator=(const SceneRenderer&) = delete;

    /// The bytes of heights and triangles that may be held on the GPU; without a call, any number.
    void setMemory(std::size_t bytes);
    /// Those that are held.
    [[nodiscard]] std::size_t memoryHeld() const { return m_surface.bytes() + m_boxSurface.bytes(); }
    /// The bytes of one texture of heights (SurfaceRenderer); without a call, any number.
    void setMostTextureBytes(std::size_t bytes);
    /// The triangles of the stock that are drawn at most (SurfaceRenderer); without a call, any number.
    void setMostTriangles(std::size_t triangles);
    /// Uploads what differs from the previous frame. If the driver cannot hold the heights of
    /// the grid, no stock is drawn and gridFits() is false. If the budget is too small, the next call
    /// continues, with the same frame unless the other one has another grid; until it is complete, only the
    /// backdrop is drawn, and then it must be drawn once before the next one is taken.
    UploadCounts upload(const FramePtr& frame, const UploadBudget& budget = {});
    /// Whether the uploaded frame is not complete.
    [[nodiscard]] bool framePending() const { return m_framePending; }
    /// Whether it took several calls, and has not been drawn yet.
    [[nodiscard]] bool frameWaits() const { return m_frameWaits && !m_framePending; }
    /// The frame that was uploaded, perhaps in part.
    [[nodiscard]] const FramePtr& frame() const { return m_frame; }
    /// Sets a detail region, whose z-map and surface are drawn in place of that part of the uploaded frame;
    /// null: none. It is drawn once it is complete, which may take several calls; the frame may then be
    /// incomplete too. Returns false if the driver cannot hold its heights; it is not drawn then.
    bool uploadBox(const FramePtr& box, const UploadBudget& budget = {});
    /// Loads what this view of the uploaded frame and detail region needs, if not all heights fit the memory.
    /// Call it before draw().
    void refine(const View& view, const UploadBudget& budget = {});
    /// How the picture of that view differs from that of all points.
    [[nodiscard]] const Coarseness& coarseness() const { return m_coarseness; }
    /// Whether the detail region needs another call.
    [[nodiscard]] bool boxPending() const { return m_boxPending; }
    /// Processes a part of the toolpath that is shown through the stock; it is drawn once complete, which may
    /// take several calls for a long program. Needs no context.
    void advancePath(const UploadBudget& budget) { m_path.advanceOverview(budget); }
    [[nodiscard]] bool pathPending() const { return m_path.overviewPending(); }
    /// Uploads deviations of the stock, which colour the uploaded frame where they are of its heights; null:
    /// none. If the budget is too small, the next call continues. The frame must be complete.
    void uploadDeviation(const Deviation* deviation, const PartTolerance& tolerance,
                         const UploadBudget& budget = {});
    /// Whether the uploaded frame can be coloured.
    [[nodiscard]] Colouring colouring() const { return m_colouring; }
    /// Uploads the design part; null: none. It is drawn once complete, which may take several calls.
    void uploadPart(const std::shared_ptr<const DesignPart>& part, const UploadBudget& budget = {});
    [[nodiscard]] bool partPending() const { return m_part.isPending(); }
    /// Frees the GPU resources of a detail region that is no longer needed. The frame may use the memory, and
    /// then be incomplete.
    void releaseBox(const UploadBudget& budget = {});
    /// Draws the uploaded frame, or only the backdrop. Sets viewport, depth and culling; leaves blending and
    /// depth test off and no program bound, as QPainter expects.
    void draw(const View& view, const SceneOptions& options);
    /// Copies an image of that size from one framebuffer to another and resolves its multisampling.
    void copyPicture(GLuint from, GLuint to, const glm::ivec2& pixels);
    /// Waits until all commands issued so far have finished (for measuring).
    void finish();
    /// Frees the GPU resources.
    void release();

    [[nodiscard]] bool gridFits() const { return m_gridFits; }
    [[nodiscard]] std::size_t triangles(SurfaceBuffer::Part part) const { return m_surface.triangles(part); }

private:
    SceneRenderer(Gl& gl, int mostTexturePoints);
    void drawBox(const View& view, const SceneOptions& options, const StockView& stockView,
                 const Vec3& origin);
    void drawBackdrop(const SceneOptions& options);
    void shareMemory(bool withBox, const UploadBudget& budget = {});
    void freeBox();

    Gl& m_gl;
    ShaderProgram m_backdrop;
    SurfaceRenderer m_surface;
    FixtureRenderer m_fixtures;
    PartRenderer m_part;
    Colouring m_colouring = Colouring::none;
    CutterRenderer m_cutter;
    PathRenderer m_path;
    GLuint m_emptyArray = 0; ///< for vertices that the shader computes from their index alone
    FramePtr m_frame;
    bool m_framePending = false;
    bool m_frameWaits = false; ///< the next one must wait
    bool m_stale = true;       ///< the same frame must be uploaded again
    SurfaceRenderer m_boxSurface;
    BoxFrame m_boxFrame;
    FramePtr m_box;
    FramePtr m_boxIn; ///< the frame that the region's edge was created for
    bool m_boxPending = false;
    bool m_gridFits = true;
    std::size_t m_memory = std::numeric_limits<std::size_t>::max();
    bool m_shared = false; ///< with a detail region
    Coarseness m_coarseness;
};

} // namespace proveout
