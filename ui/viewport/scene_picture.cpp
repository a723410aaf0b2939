// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/scene_picture.h"

#include <chrono>
#include <cstdint>
#include <utility>

#include <QElapsedTimer>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QOpenGLWidget>

#include "ui/viewport/closer_look.h"
#include "ui/viewport/part_view.h"

namespace proveout {
namespace {

constexpr int kRestMilliseconds = 250;
/// The longest time for which the uploads of a large frame, of a detail region, and of points in the view may
/// block the UI thread at once.
constexpr std::chrono::milliseconds kUploadAtOnce{25};
/// A frame with so many points is large.
constexpr std::int64_t kLargeFrame = 8'000'000;
/// In software, a texture is cleared when it is created: 50 ms.
constexpr std::size_t kMostTextureBytesInSoftware = 64'000'000;
/// More triangles are not drawn within a quarter of a second in software, or in a frame otherwise.
constexpr std::size_t kMostTrianglesInSoftware = std::size_t{1} << 22;
constexpr std::size_t kMostTriangles = std::size_t{1} << 25;
/// In software, an antialiased image takes about this many times as long as a plain one …
constexpr double kSmoothCost = 4;
/// … and must not block the window for longer than this.
constexpr double kLongestSmoothSeconds = 0.25;

double seconds(const QElapsedTimer& timer) {
    return static_cast<double>(timer.nsecsElapsed()) * 1e-9;
}

bool isLarge(const FramePtr& frame) {
    return frame != nullptr &&
           static_cast<std::int64_t>(frame->zmap.grid().nx) * frame->zmap.grid().ny >= kLargeFrame;
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
    if (m_renderer == nullptr)
        return;
    m_renderer->setMemory(m_memory);
    if (m_software)
        m_renderer->setMostTextureBytes(kMostTextureBytesInSoftware);
    m_renderer->setMostTriangles(m_software ? kMostTrianglesInSoftware : kMostTriangles);
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
    m_kept.reset();
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

std::optional<ScenePicture::Seconds> ScenePicture::paint(const View& view, const FramePtr& frame) {
    if (m_renderer == nullptr)
        return Seconds();
    m_view = view;
    m_frame = frame;
    upload();
    if (workPending())
        m_uploading.start(0);
    m_preparing = false;
    if (m_renderer->framePending()) {
        showKeptImage();
        return std::nullopt;
    }
    Seconds took;
    took.upload = std::exchange(m_uploadSeconds, 0);
    QElapsedTimer timer;
    timer.start();
    draw(view);
    m_renderer->finish();
    took.draw = seconds(timer);
    if (!m_smooth)
        m_plainSeconds = took.draw;
    keepImage();
    const bool worthIt = m_software && kSmoothCost * m_plainSeconds < kLongestSmoothSeconds;
    if (worthIt && !m_smooth && frame != nullptr && !frame->playing)
        m_rest.start();
    return m_renderer->frame() == frame ? std::optional(took) : std::nullopt;
}

void ScenePicture::upload() {
    QElapsedTimer timer;
    timer.start();
    const UploadBudget slice(kUploadAtOnce);
    const UploadBudget ofFrame = isLarge(m_frame) ? slice : UploadBudget();
    m_uploaded = m_renderer->upload(m_frame, ofFrame);
    if (!m_renderer->framePending()) {
        m_boxFits = m_renderer->uploadBox(m_look.picture(), slice);
        if (!m_look.box())
            m_renderer->releaseBox(ofFrame);
    }
    if (!m_renderer->framePending())
        uploadPart(slice);
    if (!m_renderer->framePending())
        m_renderer->refine(m_view, slice);
    // Waiting for the GPU costs nothing at 30 frames per second and makes the measured times reliable.
    m_renderer->finish();
    m_uploadSeconds += seconds(timer);
    if (showsHiddenPath())
        m_renderer->advancePath(slice);
    if (m_frame != nullptr && (m_renderer->framePending() || m_renderer->frame() != m_frame))
        emit partUploaded(m_frame->sequence);
}

void ScenePicture::uploadPart(const UploadBudget& budget) {
    if (m_part == nullptr)
        return;
    const auto comparison = m_part->comparison();
    m_renderer->uploadDeviation(comparison ? &comparison->deviation : nullptr,
                                comparison ? comparison->tolerance : PartTolerance(), budget);
    m_renderer->uploadPart(m_part->part(), budget);
}

/// Of a large frame, whose successor may take several slices to upload.
void ScenePicture::keepImage() {
    const FramePtr& drawn = m_renderer->frame();
    if (!isLarge(drawn)) {
        m_kept.reset();
        return;
    }
    const QSize size(m_view.pixels.x, m_view.pixels.y);
    if (m_kept == nullptr || m_kept->size() != size)
        m_kept = std::make_unique<QOpenGLFramebufferObject>(size);
    m_renderer->copyPicture(m_widget.defaultFramebufferObject(), m_kept->handle(), m_view.pixels);
    m_kept->bindDefault();
    m_keptView = m_view;
    m_keptGrid = drawn->zmap.grid();
}

void ScenePicture::showKeptImage() {
    const bool fits =
        m_kept != nullptr && m_keptView.pixels == m_view.pixels && m_keptGrid == m_frame->zmap.grid();
    m_preparing = !fits || m_keptView.clipFromWorld != m_view.clipFromWorld;
    if (!fits)
        m_renderer->draw(m_view, m_options);
    else
        m_renderer->copyPicture(m_kept->handle(), m_widget.defaultFramebufferObject(), m_view.pixels);
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
    upload();
    m_widget.doneCurrent();
    if (workPending() && !m_renderer->frameWaits())
        m_uploading.start(0);
    else
        repaintSoon();
}

bool ScenePicture::showsHiddenPath() const {
    return m_options.pathThroughStock && m_options.path != PathShown::none;
}

/// Whether work is pending that the image needs and that is done in slices.
bool ScenePicture::workPending() const {
    return m_renderer->framePending() || m_renderer->frame() != m_frame || m_renderer->boxPending() ||
           m_renderer->coarseness().pending || m_renderer->colouring() == Colouring::pending ||
           m_renderer->partPending() || (showsHiddenPath() && m_renderer->pathPending());
}

} // namespace proveout
