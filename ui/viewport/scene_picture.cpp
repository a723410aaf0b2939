// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/scene_picture.h"

#include <chrono>

#include <QElapsedTimer>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QOpenGLWidget>

#include "ui/viewport/closer_look.h"

namespace proveout {
namespace {

constexpr int kRestMilliseconds = 250;
/// The longest time for which one upload of a detail region, or of points in the view, may block the UI
/// thread.
constexpr std::chrono::milliseconds kUploadAtOnce{25};
/// In software, an antialiased image takes about this many times as long as a plain one …
constexpr double kSmoothCost = 4;
/// … and must not block the window for longer than this.
constexpr double kLongestSmoothSeconds = 0.25;

double seconds(const QElapsedTimer& timer) {
    return static_cast<double>(timer.nsecsElapsed()) * 1e-9;
}

} // namespace

ScenePicture::ScenePicture(QOpenGLWidget& widget, const CloserLook& look, const SceneOptions& options,
                           bool software)
    : m_widget(widget), m_look(look), m_options(options), m_software(software) {
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRestMilliseconds);
    connect(&m_rest, &QTimer::timeout, this, [this] {
        m_smooth = true;
        m_widget.update();
    });
    m_uploading.setSingleShot(true);
    connect(&m_uploading, &QTimer::timeout, this, &ScenePicture::continueUploading);
}

ScenePicture::~ScenePicture() {
    release();
}

void ScenePicture::initialize() {
    // The context is destroyed when the widget moves to another window or the driver resets it; this function
    // is called again for the new one.
    connect(m_widget.context(), &QOpenGLContext::aboutToBeDestroyed, this, &ScenePicture::release);
    m_renderer = SceneRenderer::create();
    if (m_renderer != nullptr)
        m_renderer->setMemory(m_memory);
}

void ScenePicture::setMemory(std::size_t bytes) {
    m_memory = bytes;
    if (m_renderer != nullptr)
        m_renderer->setMemory(bytes);
    repaintSoon();
}

void ScenePicture::release() {
    m_widget.makeCurrent();
    m_smoothTarget.reset();
    if (m_renderer != nullptr)
        m_renderer->release();
    m_renderer.reset();
    m_widget.doneCurrent();
}

void ScenePicture::repaintSoon() {
    m_smooth = false;
    m_rest.stop();
    m_widget.update();
}

ScenePicture::Seconds ScenePicture::paint(const View& view, const FramePtr& frame) {
    if (m_renderer == nullptr)
        return {};
    Seconds took;
    QElapsedTimer timer;
    timer.start();
    upload(view, frame);
    // Waiting for the GPU costs nothing at 30 frames per second and makes the measured times reliable.
    m_renderer->finish();
    took.upload = seconds(timer);
    timer.restart();
    draw(view);
    m_renderer->finish();
    took.draw = seconds(timer);
    if (!m_smooth)
        m_plainSeconds = took.draw;
    if (workPending())
        m_uploading.start(0);
    const bool worthIt = m_software && kSmoothCost * m_plainSeconds < kLongestSmoothSeconds;
    if (worthIt && !m_smooth && frame != nullptr && !frame->playing)
        m_rest.start();
    return took;
}

void ScenePicture::upload(const View& view, const FramePtr& frame) {
    m_view = view;
    m_uploaded = m_renderer->upload(frame);
    m_boxFits = m_renderer->uploadBox(m_look.picture(), UploadBudget(kUploadAtOnce));
    if (!m_look.box())
        m_renderer->releaseBox();
    m_renderer->refine(view, UploadBudget(kUploadAtOnce));
    if (showsHiddenPath())
        m_renderer->advancePath(UploadBudget(kUploadAtOnce));
}

void ScenePicture::draw(const View& view) {
    if (m_smooth)
        drawSmooth(view);
    else
        m_renderer->draw(view, m_options);
}

void ScenePicture::drawSmooth(const View& view) {
    const QSize size(view.pixels.x, view.pixels.y);
    if (m_smoothTarget == nullptr || m_smoothTarget->size() != size) {
        QOpenGLFramebufferObjectFormat format;
        format.setAttachment(QOpenGLFramebufferObject::Depth);
        format.setSamples(4);
        m_smoothTarget = std::make_unique<QOpenGLFramebufferObject>(size, format);
    }
    m_smoothTarget->bind();
    m_renderer->draw(view, m_options);
    m_renderer->copyPicture(m_smoothTarget->handle(), m_widget.defaultFramebufferObject(), view.pixels);
}

/// Uploads in slices between the window's events, and repaints only when there is something new to show.
void ScenePicture::continueUploading() {
    if (m_renderer == nullptr)
        return;
    m_widget.makeCurrent();
    m_boxFits = m_renderer->uploadBox(m_look.picture(), UploadBudget(kUploadAtOnce));
    m_renderer->refine(m_view, UploadBudget(kUploadAtOnce));
    m_renderer->finish();
    m_widget.doneCurrent();
    if (showsHiddenPath())
        m_renderer->advancePath(UploadBudget(kUploadAtOnce));
    if (workPending())
        m_uploading.start(0);
    else
        repaintSoon();
}

bool ScenePicture::showsHiddenPath() const {
    return m_options.pathThroughStock && m_options.path != PathShown::none;
}

/// Whether work is pending that the image needs and that is done in slices.
bool ScenePicture::workPending() const {
    return m_renderer->boxPending() || m_renderer->coarseness().pending ||
           (showsHiddenPath() && m_renderer->pathPending());
}

} // namespace proveout
