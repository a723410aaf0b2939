// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <QImage>
#include <QOffscreenSurface>
#include <QOpenGLContext>

#include "ui/gl/scene_renderer.h"

namespace proveout {

/// A context of OpenGL 3.3 without a window, and a scene renderer in it.
class OffscreenPicture {
public:
    OffscreenPicture();
    ~OffscreenPicture();

    /// False where this machine or platform has no OpenGL 3.3.
    [[nodiscard]] bool usable() const { return m_renderer != nullptr; }
    [[nodiscard]] SceneRenderer& renderer() { return *m_renderer; }
    /// Of a pixel in the next pictures; 0: edges are not smoothed.
    void setSamples(int samples) { m_samples = samples; }
    /// Uploads and draws.
    [[nodiscard]] QImage draw(const FramePtr& frame, const View& view, const SceneOptions& options = {},
                              const FramePtr& box = nullptr, const UploadBudget& ofBox = {});
    /// Of the last draw().
    [[nodiscard]] const UploadCounts& uploaded() const { return m_uploaded; }

private:
    QOffscreenSurface m_surface;
    QOpenGLContext m_context;
    std::unique_ptr<SceneRenderer> m_renderer;
    UploadCounts m_uploaded;
    int m_samples = 0;
};

} // namespace proveout
