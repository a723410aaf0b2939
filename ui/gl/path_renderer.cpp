// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/path_renderer.h"

#include <algorithm>

namespace proveout {
namespace {
constexpr float kDoneOpacity = 0.45f;
constexpr float kAheadOpacity = 0.95f;
constexpr float kHiddenOpacity = 0.34f;
constexpr float kHiddenDone = 0.5f; // factor for blocks already executed
/// Where lines are dense they are drawn fainter, so that together they only tint the stock and do not hide
/// its shape. This is the average coverage of a pixel above which they become fainter.
constexpr double kFullCoverage = 0.6;
constexpr float kFaintest = 0.02f;
constexpr float kWidth = 1.6f;       // logical pixels
constexpr float kDashPixels = 11.0f; // a dash with its gap
} // namespace

void PathRenderer::setPosition(std::shared_ptr<const Program> program, std::size_t block) {
    m_path = std::move(program);
    m_block = block;
    if (m_overview.setProgram(m_path))
        m_overviewUploaded = false;
}

void PathRenderer::prepare(Gl& gl, bool whole) {
    whole = whole && std::max(m_path->blockCount(), m_path->motionCount()) <= kMostWholeMotions;
    BlockRange range{0, m_path->blockCount()};
    if (!whole)
        range = blocksForFrame(
            *m_path, std::min(m_block, range.last),
            {m_block - std::min(m_block, kBlocksBehind), std::min(m_block + kBlocksAhead, range.last)});
    const auto [first, last] = range;
    if (m_shownPath == m_path && m_shownFirst == first && m_shownLast == last)
        return;
    m_lines = pathLines(*m_path, first, last);
    m_vertices.write(gl, m_lines.vertices.data(), m_lines.vertices.size(), {3, 1, 1});
    m_lines.vertices = {};
    m_shownPath = m_path;
    m_shownFirst = first;
    m_shownLast = last;
}

void PathRenderer::drawRun(Gl& gl, VertexBuffer& vertices, const SceneOptions& options, std::size_t first,
                           std::size_t last, float opacity) {
    m_program.set(gl, "colours[0]", glm::vec4(options.colours.rapid, opacity));
    m_program.set(gl, "colours[1]", glm::vec4(options.colours.feed, opacity));
    m_program.set(gl, "colours[2]", glm::vec4(options.colours.arc, opacity));
    vertices.draw(gl, GL_LINES, first, last - first);
}

void PathRenderer::begin(Gl& gl, const StockView& view, const Vec3& shift) {
    m_program.bind(gl);
    setView(gl, m_program, view);
    m_program.set(gl, "shift", glm::vec3(shift));
    m_program.set(gl, "width", kWidth * view.pixelRatio);
    m_program.set(gl, "pixelsPerMm", view.pixelsPerMm);
    m_program.set(gl, "dashes", glm::vec3(kDashPixels * view.pixelRatio, 0, 0));
    gl.glEnable(GL_BLEND);
    // Keeps the alpha at 1, because the window system blends a QOpenGLWidget by its alpha.
    gl.glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl.glDepthMask(GL_FALSE);
    gl.glDisable(GL_CULL_FACE);
}

void PathRenderer::end(Gl& gl) {
    gl.glEnable(GL_CULL_FACE);
    gl.glDepthMask(GL_TRUE);
    gl.glDisable(GL_BLEND);
}

void PathRenderer::draw(Gl& gl, const StockView& view, const SceneOptions& options, const Vec3& stockOrigin) {
    if (m_path == nullptr || options.path == PathShown::none)
        return;
    prepare(gl, options.path == PathShown::whole);
    begin(gl, view, m_lines.origin - stockOrigin);
    const std::size_t done = m_lines.verticesBefore(m_block);
    drawRun(gl, m_vertices, options, 0, done, kDoneOpacity);
    drawRun(gl, m_vertices, options, done, m_vertices.size(), kAheadOpacity);
    end(gl);
}

void PathRenderer::drawHidden(Gl& gl, const StockView& view, const SceneOptions& options,
                              const Vec3& stockOrigin) {
    if (m_path == nullptr || options.path == PathShown::none || overviewPending())
        return;
    if (!m_overviewUploaded) {
        const std::vector<PathVertex>& vertices = m_overview.vertices();
        m_overviewVertices.write(gl, vertices.data(), vertices.size(), {3, 1, 1});
        m_overviewUploaded = true;
    }
    const double covered =
        m_overview.coveragePerMm() * double{kWidth * view.pixelRatio} / double{view.pixelsPerMm};
    const float opacity =
        std::max(kFaintest, kHiddenOpacity / static_cast<float>(std::max(1.0, covered / kFullCoverage)));
    begin(gl, view, m_overview.origin() - stockOrigin);
    gl.glDepthFunc(GL_GREATER);
    const std::size_t done = m_overview.verticesBefore(m_block);
    drawRun(gl, m_overviewVertices, options, 0, done, kHiddenDone * opacity);
    drawRun(gl, m_overviewVertices, options, done, m_overviewVertices.size(), opacity);
    gl.glDepthFunc(GL_LESS);
    end(gl);
}

void PathRenderer::release(Gl& gl) {
    m_vertices.release(gl);
    m_overviewVertices.release(gl);
    m_overviewUploaded = false;
    m_shownPath.reset();
}

} // namespace proveout
