// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <memory>

#include <QImage>
#include <QOffscreenSurface>
#include <QOpenGLContext>

#include "ui/gl/scene_renderer.h"
#include "ui/viewport/camera.h"

namespace proveout {

/// An OpenGL 3.3 context without a window, with a scene renderer.
class OffscreenPicture {
public:
    /// As SceneRenderer::create().
    explicit OffscreenPicture(int mostTexturePoints = std::numeric_limits<int>::max());
    ~OffscreenPicture();

    /// False if this machine or platform has no OpenGL 3.3.
    [[nodiscard]] bool usable() const { return m_renderer != nullptr; }
    [[nodiscard]] SceneRenderer& renderer() { return *m_renderer; }
    /// Samples per pixel for the next images; 0: no antialiasing.
    void setSamples(int samples) { m_samples = samples; }
    /// Uploads and draws.
    [[nodiscard]] QImage draw(const FramePtr& frame, const View& view, const SceneOptions& options = {},
                              const FramePtr& box = nullptr, const UploadBudget& ofBox = {});
    /// The uploads of the last draw().
    [[nodiscard]] const UploadCounts& uploaded() const { return m_uploaded; }

private:
    QOffscreenSurface m_surface;
    QOpenGLContext m_context;
    std::unique_ptr<SceneRenderer> m_renderer;
    UploadCounts m_uploaded;
    int m_samples = 0;
};

/// A backdrop of a colour that no stock has, and no path.
[[nodiscard]] SceneOptions testOptions();

/// A camera that shows all of a box; pixels.
[[nodiscard]] Camera cameraFitted(const Box3& box, StandardView view, bool perspective, int width,
                                  int height);

} // namespace proveout
