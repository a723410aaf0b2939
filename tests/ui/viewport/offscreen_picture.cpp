// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/viewport/offscreen_picture.h"

#include <QOpenGLFramebufferObject>

namespace proveout {

OffscreenPicture::OffscreenPicture(int mostTexturePoints) {
    if (!probeGl().usable)
        return;
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    m_context.setFormat(format);
    m_surface.setFormat(format);
    m_surface.create();
    if (m_context.create() && m_context.makeCurrent(&m_surface))
        m_renderer = SceneRenderer::create(mostTexturePoints);
}

OffscreenPicture::~OffscreenPicture() {
    if (m_renderer == nullptr)
        return;
    m_context.makeCurrent(&m_surface);
    m_renderer->release();
    m_renderer.reset();
    m_context.doneCurrent();
}

QImage OffscreenPicture::draw(const FramePtr& frame, const View& view, const SceneOptions& options,
                              const FramePtr& box, const UploadBudget& ofBox) {
    m_context.makeCurrent(&m_surface); // a test may use two of them
    QOpenGLFramebufferObjectFormat format;
    format.setAttachment(QOpenGLFramebufferObject::Depth);
    format.setSamples(m_samples);
    QOpenGLFramebufferObject target(view.pixels.x, view.pixels.y, format);
    target.bind();
    m_uploaded = m_renderer->upload(frame);
    if (!m_renderer->uploadBox(box, ofBox))
        qWarning("the box was not taken");
    m_renderer->refine(view);
    m_renderer->draw(view, options);
    return target.toImage().convertToFormat(QImage::Format_RGB32);
}

SceneOptions testOptions() {
    SceneOptions options;
    options.colours.backdropTop = options.colours.backdropBottom = {1, 0, 1};
    options.path = PathShown::none;
    return options;
}

Camera cameraFitted(const Box3& box, StandardView view, bool perspective, int width, int height) {
    Camera camera;
    camera.setPicture(width, height, 1);
    camera.setPerspective(perspective);
    camera.setStandardView(view);
    camera.fit(box);
    return camera;
}

} // namespace proveout
