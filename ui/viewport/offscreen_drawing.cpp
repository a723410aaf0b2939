// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/offscreen_drawing.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QThread>

#include "core/base/stop_watch.h"
#include "core/verification/findings/window_findings.h"
#include "ui/gl/scene_renderer.h"
#include "ui/viewport/camera.h"

namespace proveout {

struct OffscreenDrawing::State {
    QOffscreenSurface surface;
    QOpenGLContext context;
    std::unique_ptr<QOpenGLFramebufferObject> target;
    std::unique_ptr<SceneRenderer> renderer;
    QSize size;
    View view;
    bool viewKnown = false;

    void release() {
        if (renderer)
            renderer->release();
        renderer.reset();
    }
};

namespace {

View cornerView(const StockBox& stock, const QSize& size) {
    Box3 box;
    box.add(stock.corner);
    box.add(Vec3(stock.corner.x + stock.width, stock.corner.y + stock.depth, stock.floorZ()));
    Camera camera;
    camera.setPicture(size.width(), size.height(), 1);
    camera.setStandardView(StandardView::iso);
    camera.fit(box);
    return camera.view(box);
}

} // namespace

Result<std::unique_ptr<DrawCost>> OffscreenDrawing::create(int width, int height, QThread* thread) {
    auto state = std::make_unique<State>();
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    state->surface.setFormat(format);
    state->surface.create();
    state->context.setFormat(format);
    state->size = {width, height};
    const bool current = state->context.create() && state->context.makeCurrent(&state->surface);
    const bool usable = current && SceneRenderer::create() != nullptr;
    if (current)
        state->context.doneCurrent();
    if (!usable)
        return failure(window_finding::kOpenGlMissing);
    if (thread != nullptr)
        state->context.moveToThread(thread);
    return std::unique_ptr<DrawCost>(new OffscreenDrawing(std::move(state)));
}

OffscreenDrawing::OffscreenDrawing(std::unique_ptr<State> state) : m_state(std::move(state)) {}

OffscreenDrawing::~OffscreenDrawing() {
    end();
}

void OffscreenDrawing::begin() {
    m_state->context.makeCurrent(&m_state->surface);
    m_state->release();
    if (!m_state->target)
        m_state->target =
            std::make_unique<QOpenGLFramebufferObject>(m_state->size, QOpenGLFramebufferObject::Depth);
    m_state->target->bind();
    m_state->renderer = SceneRenderer::create();
    m_state->viewKnown = false;
}

void OffscreenDrawing::end() {
    if (m_state->target) {
        m_state->context.makeCurrent(&m_state->surface);
        m_state->release();
        m_state->target.reset();
        m_state->context.doneCurrent();
    }
    if (m_state->context.thread() == QThread::currentThread())
        m_state->context.moveToThread(m_state->surface.thread());
}

DrawCost::Seconds OffscreenDrawing::draw(const FramePtr& frame) {
    if (!m_state->renderer)
        return {};
    if (!m_state->viewKnown)
        m_state->view = cornerView(frame->zmap.stock(), m_state->size);
    m_state->viewKnown = true;
    Seconds seconds;
    const StopWatch uploading;
    m_state->renderer->upload(frame);
    m_state->renderer->finish();
    seconds.upload = uploading.seconds();
    const StopWatch drawing;
    m_state->renderer->draw(m_state->view, {});
    m_state->renderer->finish();
    seconds.draw = drawing.seconds();
    return seconds;
}

} // namespace proveout
