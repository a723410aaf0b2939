// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/scene_renderer.h"

namespace proveout {

namespace {

/// The rectangle of a detail region in stock coordinates, open on sides at the edge of the stock; empty if
/// there is no region.
glm::vec4 cutOut(const FramePtr& box, const Grid& around) {
    if (box == nullptr)
        return {1, 1, -1, -1};
    constexpr float kBeyond = 1e9F;
    const Grid& grid = box->zmap.grid();
    const BoxSides open = sidesAtEdge(around, grid);
    return {open.west ? -kBeyond : grid.x(0) - around.x0, open.south ? -kBeyond : grid.y(0) - around.y0,
            open.east ? kBeyond : grid.x(grid.nx - 1) - around.x0,
            open.north ? kBeyond : grid.y(grid.ny - 1) - around.y0};
}

/// Of the stock coordinates.
Vec3 originOf(const Frame& frame) {
    const Grid& grid = frame.zmap.grid();
    return {grid.x0, grid.y0, frame.zmap.stock().floorZ()};
}

} // namespace

std::unique_ptr<SceneRenderer> SceneRenderer::create(int mostTexturePoints) {
    Gl* gl = currentGl();
    if (gl == nullptr)
        return nullptr;
    std::unique_ptr<SceneRenderer> renderer(new SceneRenderer(*gl, mostTexturePoints));
    const bool valid = renderer->m_backdrop.valid() && renderer->m_surface.valid() &&
                       renderer->m_fixtures.valid() && renderer->m_part.valid() &&
                       renderer->m_cutter.valid() && renderer->m_path.valid() &&
                       renderer->m_boxSurface.valid() && renderer->m_boxFrame.valid();
    return valid ? std::move(renderer) : nullptr;
}

SceneRenderer::SceneRenderer(Gl& gl, int mostTexturePoints)
    : m_gl(gl), m_backdrop({{"backdrop.vert"}, nullptr, {"backdrop.frag"}, {}}), m_surface(mostTexturePoints),
      m_boxSurface(mostTexturePoints) {
    m_gl.glGenVertexArrays(1, &m_emptyArray);
}

UploadCounts SceneRenderer::upload(const FramePtr& newest, const UploadBudget& budget) {
    // A frame that is replaced before it is complete would never be shown while a program is played.
    m_frameWaits = m_frameWaits && newest != nullptr && newest->zmap.grid() == m_frame->zmap.grid();
    const FramePtr frame = m_frameWaits ? m_frame : newest;
    if (frame != nullptr && frame == m_frame && !m_framePending && !m_stale)
        return {};
    m_frame = frame;
    m_framePending = false;
    if (frame == nullptr)
        return {};
    m_stale = false;
    m_path.setPosition(frame->program, frame->block);
    m_cutter.setCutter(m_gl,
                       frame->cutterKnown && frame->setup ? frame->setup->tools.find(frame->tool) : nullptr);
    m_fixtures.setFixtures(m_gl, frame->setup ? frame->setup->fixtures : Fixtures(), originOf(*frame));
    m_gridFits = m_surface.fits(m_gl, frame->zmap.grid());
    if (!m_gridFits || frame->zmap.tileCount() == 0)
        return {};
    const UploadCounts counts = m_surface.upload(m_gl, *frame, budget);
    m_gridFits = counts.fits;
    m_framePending = counts.fits && !counts.whole;
    m_frameWaits = m_frameWaits || m_framePending;
    return counts;
}

void SceneRenderer::uploadDeviation(const Deviation* deviation, const PartTolerance& tolerance,
                                    const UploadBudget& budget) {
    m_colouring = Colouring::none;
    if (m_frame != nullptr && m_gridFits && m_frame->zmap.tileCount() > 0)
        m_colouring = m_surface.uploadDeviation(m_gl, m_frame->zmap, deviation, tolerance, budget);
}

void SceneRenderer::uploadPart(const std::shared_ptr<const DesignPart>& part, const UploadBudget& budget) {
    if (m_frame != nullptr)
        m_part.upload(m_gl, part, originOf(*m_frame), budget);
}

void SceneRenderer::setMostTriangles(std::size_t triangles) {
    m_stale = true;
    m_surface.setMostTriangles(triangles);
    m_boxSurface.setMostTriangles(triangles);
}

void SceneRenderer::setMostTextureBytes(std::size_t bytes) {
    m_stale = true;
    m_surface.setMostTextureBytes(bytes);
    m_boxSurface.setMostTextureBytes(bytes);
}

void SceneRenderer::setMemory(std::size_t bytes) {
    m_memory = bytes;
    shareMemory(m_shared);
}

/// A detail region gets a quarter: it is a small part of the stock, but much finer.
void SceneRenderer::shareMemory(bool withBox, const UploadBudget& budget) {
    m_stale = true;
    const bool changed = withBox != m_shared;
    m_shared = withBox;
    const std::size_t ofBox = m_memory / 4;
    m_surface.setLimit(withBox ? m_memory - ofBox : m_memory);
    m_boxSurface.setLimit(ofBox);
    if (changed)
        upload(m_frame, budget);
}

void SceneRenderer::refine(const View& view, const UploadBudget& budget) {
    m_coarseness = {};
    if (m_frame == nullptr || !m_gridFits || m_frame->zmap.tileCount() == 0)
        return;
    m_coarseness = m_surface.refine(m_gl, *m_frame, view, budget);
    if (m_box == nullptr)
        return;
    const Coarseness ofBox = m_boxSurface.refine(m_gl, *m_box, view, budget);
    m_coarseness.coarser = m_coarseness.coarser || ofBox.coarser;
    m_coarseness.tooManyTriangles = m_coarseness.tooManyTriangles || ofBox.tooManyTriangles;
    m_coarseness.pending = m_coarseness.pending || ofBox.pending;
}

bool SceneRenderer::uploadBox(const FramePtr& box, const UploadBudget& budget) {
    m_boxPending = false;
    if (box != nullptr && !m_shared)
        shareMemory(true, budget);
    if (box != nullptr && m_framePending) {
        m_boxPending = true;
        return true;
    }
    const bool drawn = box != nullptr && m_frame != nullptr && m_boxSurface.fits(m_gl, box->zmap.grid());
    if (!drawn) {
        m_box.reset();
        m_boxIn.reset();
        return box == nullptr;
    }
    if (box != m_box) {
        m_box.reset(); // the uploaded content no longer belongs to that frame
        const UploadCounts counts = m_boxSurface.upload(m_gl, *box, budget);
        if (!counts.fits) {
            m_boxIn.reset();
            return false;
        }
        m_boxPending = !counts.whole;
        if (m_boxPending)
            return true;
    }
    if (box != m_box || m_frame != m_boxIn)
        m_boxFrame.setEdge(m_gl, boxEdge(m_frame->zmap, box->zmap, m_frame->parameters.allowance));
    m_box = box;
    m_boxIn = m_frame;
    return true;
}

void SceneRenderer::drawBox(const View& view, const SceneOptions& options, const StockView& stockView,
                            const Vec3& origin) {
    const Grid& grid = m_box->zmap.grid();
    const StockBox& stock = m_box->zmap.stock();
    m_gl.glBindVertexArray(m_emptyArray);
    m_boxSurface.draw(m_gl, StockView(view, {grid.x0, grid.y0, stock.floorZ()}), options, m_box->zmap);
    m_gl.glBindVertexArray(0);
    m_boxFrame.draw(m_gl, stockView, options, glm::vec3(Vec3(grid.x0, grid.y0, stock.topZ()) - origin));
}

void SceneRenderer::drawBackdrop(const SceneOptions& options) {
    m_gl.glDisable(GL_DEPTH_TEST);
    m_gl.glDepthMask(GL_FALSE);
    m_backdrop.bind(m_gl);
    m_backdrop.set(m_gl, "topColour", options.colours.backdropTop);
    m_backdrop.set(m_gl, "bottomColour", options.colours.backdropBottom);
    m_gl.glDrawArrays(GL_TRIANGLES, 0, 3);
    m_gl.glDepthMask(GL_TRUE);
}

void SceneRenderer::draw(const View& view, const SceneOptions& options) {
    m_gl.glViewport(0, 0, view.pixels.x, view.pixels.y);
    m_gl.glDisable(GL_BLEND);
    m_gl.glDisable(GL_SCISSOR_TEST);
    m_gl.glClear(GL_DEPTH_BUFFER_BIT);
    m_gl.glBindVertexArray(m_emptyArray);
    m_gl.glDisable(GL_CULL_FACE);
    drawBackdrop(options);
    m_frameWaits = m_framePending;
    if (m_frame != nullptr && !m_framePending) {
        m_gl.glEnable(GL_DEPTH_TEST);
        m_gl.glDepthFunc(GL_LESS);
        m_gl.glEnable(GL_CULL_FACE);
        const Grid& grid = m_frame->zmap.grid();
        const Vec3 origin = originOf(*m_frame);
        const StockView stockView(view, origin);
        if (m_gridFits && m_frame->zmap.tileCount() > 0) {
            m_surface.setCutOut(cutOut(m_box, grid));
            m_surface.draw(m_gl, stockView, options, m_frame->zmap);
        }
        if (m_box != nullptr)
            drawBox(view, options, stockView, origin);
        m_gl.glBindVertexArray(0);
        m_fixtures.draw(m_gl, stockView, options);
        m_path.draw(m_gl, stockView, options, origin);
        if (options.pathThroughStock)
            m_path.drawHidden(m_gl, stockView, options, origin);
        m_part.draw(m_gl, stockView, options);
        const Vec3 tip = options.contact ? options.contact->tip : m_frame->cutterPosition;
        m_cutter.draw(m_gl, stockView, options, glm::vec3(tip - origin));
        m_gl.glDisable(GL_CULL_FACE);
        m_gl.glDisable(GL_DEPTH_TEST);
    }
    m_gl.glBindVertexArray(0);
    m_gl.glBindBuffer(GL_ARRAY_BUFFER, 0);
    m_gl.glUseProgram(0);
}

void SceneRenderer::copyPicture(GLuint from, GLuint to, const glm::ivec2& pixels) {
    m_gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
    m_gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
    m_gl.glBlitFramebuffer(0, 0, pixels.x, pixels.y, 0, 0, pixels.x, pixels.y, GL_COLOR_BUFFER_BIT,
                           GL_NEAREST);
    m_gl.glBindFramebuffer(GL_FRAMEBUFFER, to);
}

void SceneRenderer::finish() {
    m_gl.glFinish();
}

void SceneRenderer::freeBox() {
    m_box.reset();
    m_boxIn.reset();
    m_boxPending = false;
    m_boxSurface.release(m_gl);
    m_boxFrame.release(m_gl);
}

void SceneRenderer::releaseBox(const UploadBudget& budget) {
    freeBox();
    if (m_shared)
        shareMemory(false, budget);
}

void SceneRenderer::release() {
    m_stale = true;
    m_surface.release(m_gl);
    freeBox();
    m_fixtures.release(m_gl);
    m_part.release(m_gl);
    m_cutter.release(m_gl);
    m_path.release(m_gl);
    if (m_emptyArray != 0)
        m_gl.glDeleteVertexArrays(1, &m_emptyArray);
    m_emptyArray = 0;
}

} // namespace proveout
