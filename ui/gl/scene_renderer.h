// SPDX-License-Identifier: GPL-3.0-or-later
// Draws one frame of a simulation with OpenGL 3.3 into the framebuffer that is bound. Knows no widget, so
// that the window, studies and tests draw the same picture.
#pragma once

#include <memory>

#include "ui/gl/box_frame.h"
#include "ui/gl/cutter_renderer.h"
#include "ui/gl/path_renderer.h"
#include "ui/gl/surface_renderer.h"

namespace proveout {

/// All methods, construction and release() need the same context to be current.
class SceneRenderer {
public:
    /// Null where there is no OpenGL 3.3 or the driver refuses a shader.
    [[nodiscard]] static std::unique_ptr<SceneRenderer> create();
    SceneRenderer(const SceneRenderer&) = delete;
    SceneRenderer& operator=(const SceneRenderer&) = delete;

    /// Brings what differs from the frame before to the graphics side. A grid beyond the driver's limit draws
    /// no stock: gridFits() tells.
    UploadCounts upload(const FramePtr& frame);
    /// A box of interest, whose z-map and surface are drawn in the place of what the uploaded frame has
    /// there; null: none. It is drawn once it is whole: a large one may take several calls. A box with more
    /// points along a side than the driver takes is not drawn: false.
    bool uploadBox(const FramePtr& box, const UploadBudget& budget = {});
    /// Whether the box needs another call.
    [[nodiscard]] bool boxPending() const { return m_boxPending; }
    /// Takes a part of the toolpath that is seen through the stock, which is drawn once it is whole: a long
    /// program may take several calls. Needs no context.
    void advancePath(const UploadBudget& budget) { m_path.advanceOverview(budget); }
    [[nodiscard]] bool pathPending() const { return m_path.overviewPending(); }
    /// Frees what lies on the graphics side of a box that is not coming back.
    void releaseBox();
    /// Draws the uploaded frame, or the backdrop alone. Sets viewport, depth and culling; leaves blending and
    /// depth test off and no program bound, as QPainter wants it.
    void draw(const View& view, const SceneOptions& options);
    /// Copies a picture of that size from one framebuffer to another, several samples a pixel into one.
    void copyPicture(GLuint from, GLuint to, const glm::ivec2& pixels);
    /// Waits until everything asked for so far is done (for measuring).
    void finish();
    /// Frees what lies on the graphics side.
    void release();

    [[nodiscard]] bool gridFits() const { return m_gridFits; }
    [[nodiscard]] std::size_t triangles(SurfaceBuffer::Part part) const { return m_surface.triangles(part); }

private:
    explicit SceneRenderer(Gl& gl);
    void drawBox(const View& view, const SceneOptions& options, const StockView& stockView,
                 const Vec3& origin);
    void drawBackdrop(const SceneOptions& options);

    Gl& m_gl;
    ShaderProgram m_backdrop;
    SurfaceRenderer m_surface;
    CutterRenderer m_cutter;
    PathRenderer m_path;
    GLuint m_emptyArray = 0; ///< vertices are made from their index alone
    FramePtr m_frame;
    SurfaceRenderer m_boxSurface;
    BoxFrame m_boxFrame;
    FramePtr m_box;
    FramePtr m_boxIn; ///< the frame that its edge was made for
    bool m_boxPending = false;
    bool m_gridFits = true;
};

} // namespace proveout
