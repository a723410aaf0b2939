// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <QObject>
#include <QTimer>

#include "core/simulation/run/frame.h"
#include "ui/gl/scene_options.h"
#include "ui/gl/scene_renderer.h"
#include "ui/gl/view.h"

class QOpenGLFramebufferObject;
class QOpenGLWidget;

namespace proveout {

class CloserLook;

/// The scene as a widget draws it: uploads it, draws it, goes on uploading between the events of the window,
/// and draws a better picture once nothing changes. Owns everything of the GL context. Thread: UI.
class ScenePicture final : public QObject {
    Q_OBJECT

public:
    /// What a picture took.
    struct Seconds {
        double upload = 0;
        double draw = 0;
    };

    /// All arguments outlive this object; `look` and `options` are read whenever something is drawn.
    /// `software`: no graphics hardware draws.
    ScenePicture(QOpenGLWidget& widget, const CloserLook& look, const SceneOptions& options, bool software);
    ~ScenePicture() override;

    /// In initializeGL(), for a new context.
    void initialize();
    /// Makes the context current and gives back what it has.
    void release();
    /// In paintGL(). `frame` may be null.
    Seconds paint(const View& view, const FramePtr& frame);
    /// Something else is to be drawn.
    void repaintSoon();
    /// The widget has another size: its next picture is a plain one.
    void resized() { m_smooth = false; }

    /// Whether the shaders were compiled.
    [[nodiscard]] bool isUsable() const { return m_renderer != nullptr; }
    [[nodiscard]] bool gridFits() const { return m_renderer->gridFits(); }
    [[nodiscard]] bool boxFits() const { return m_boxFits; }
    /// Part of the detail region is not uploaded yet.
    [[nodiscard]] bool boxPending() const { return m_renderer->boxPending(); }
    /// Uploads of the last picture.
    [[nodiscard]] const UploadCounts& uploaded() const { return m_uploaded; }
    /// No better picture of what is shown is due.
    [[nodiscard]] bool atRest() const { return !m_rest.isActive(); }

private:
    void upload(const FramePtr& frame);
    void draw(const View& view);
    void drawSmooth(const View& view);
    void continueUploading();
    [[nodiscard]] bool showsHiddenPath() const;
    [[nodiscard]] bool workPending() const;

    QOpenGLWidget& m_widget;
    const CloserLook& m_look;
    const SceneOptions& m_options;
    bool m_software;
    std::unique_ptr<SceneRenderer> m_renderer;
    std::unique_ptr<QOpenGLFramebufferObject> m_smoothTarget;
    UploadCounts m_uploaded;
    bool m_boxFits = true;
    QTimer m_uploading;    ///< runs while a detail region or a long toolpath is prepared
    QTimer m_rest;         ///< the picture has not changed for a moment
    bool m_smooth = false; ///< draw with smoothed edges, although software takes long for it
    double m_plainSeconds = 0;
};

} // namespace proveout
