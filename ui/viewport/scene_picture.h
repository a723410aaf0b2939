// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>

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
class PartView;

/// The scene as a widget draws it: uploads it, draws it, continues uploading between the window's events, and
/// draws a better image once nothing changes. Owns all resources of the GL context. Thread: UI.
class ScenePicture final : public QObject {
    Q_OBJECT

public:
    /// The cost of an image.
    struct Seconds {
        double upload = 0;
        double draw = 0;
    };

    /// All arguments must outlive this object; `look` and `options` are read on every draw. `software`:
    /// rendering is done in software.
    ScenePicture(QOpenGLWidget& widget, const CloserLook& look, const SceneOptions& options, bool software);
    ~ScenePicture() override;

    /// What of the design part is shown, read on every draw; it must outlive this object. Without a call,
    /// nothing.
    void setPart(const PartView* part) { m_part = part; }
    /// Call it in initializeGL(), for a new context.
    void initialize();
    /// Makes the context current and frees its resources.
    void release();
    /// Call it in paintGL(). `frame` may be null. A large frame is uploaded between the window's events;
    /// until it is complete, the last image stays. Returns nothing if the image does not show that frame yet.
    std::optional<Seconds> paint(const View& view, const FramePtr& frame);
    /// The bytes of graphics memory that heights and triangles may take; without a call, any number.
    void setMemory(std::size_t bytes);
    /// Call it when the content has changed.
    void repaintSoon();
    /// The widget was resized: its next image is a plain one.
    void resized() { m_smooth = false; }

    /// Whether the shaders were compiled successfully.
    [[nodiscard]] bool isUsable() const { return m_renderer != nullptr; }
    [[nodiscard]] bool gridFits() const { return m_renderer->gridFits(); }
    [[nodiscard]] bool boxFits() const { return m_boxFits; }
    /// Whether part of the detail region is not uploaded yet.
    [[nodiscard]] bool boxPending() const { return m_renderer->boxPending(); }
    /// Whether the last image does not use every point of the grid in the view, because the memory is
    /// limited.
    [[nodiscard]] bool isCoarser() const { return m_renderer != nullptr && m_renderer->coarseness().coarser; }
    /// Whether it does so because the surface has more triangles than can be drawn in time.
    [[nodiscard]] bool hasTooManyTriangles() const {
        return m_renderer != nullptr && m_renderer->coarseness().tooManyTriangles;
    }
    /// Whether the stock can be coloured by its deviation from the part.
    [[nodiscard]] Colouring colouring() const {
        return m_renderer != nullptr ? m_renderer->colouring() : Colouring::none;
    }
    /// Whether rendering is done in software, which never holds all heights of a large grid.
    [[nodiscard]] bool isSoftware() const { return m_software; }
    /// Whether the last image does not show this view and stock, because the frame is not uploaded yet.
    [[nodiscard]] bool isPreparing() const { return m_preparing; }
    /// The bytes of graphics memory that heights and triangles take.
    [[nodiscard]] std::size_t memoryHeld() const {
        return m_renderer != nullptr ? m_renderer->memoryHeld() : 0;
    }
    /// The uploads of the last image.
    [[nodiscard]] const UploadCounts& uploaded() const { return m_uploaded; }
    /// Whether no better image of the current content is pending.
    [[nodiscard]] bool atRest() const { return !m_rest.isActive() && !m_uploading.isActive(); }

signals:
    /// A part of the frame was uploaded; it cannot be drawn yet.
    void partUploaded(std::uint64_t sequence);

private:
    void upload();
    void uploadPart(const UploadBudget& budget);
    void draw(const View& view);
    void drawSmooth(const View& view);
    void keepImage();
    void showKeptImage();
    void continueUploading();
    [[nodiscard]] bool showsHiddenPath() const;
    [[nodiscard]] bool workPending() const;

    QOpenGLWidget& m_widget;
    const CloserLook& m_look;
    const PartView* m_part = nullptr;
    const SceneOptions& m_options;
    bool m_software;
    std::unique_ptr<SceneRenderer> m_renderer;
    std::unique_ptr<QOpenGLFramebufferObject> m_smoothTarget;
    std::unique_ptr<QOpenGLFramebufferObject> m_kept; ///< the last image of a large frame
    View m_keptView;
    Grid m_keptGrid;
    std::size_t m_memory = std::numeric_limits<std::size_t>::max();
    View m_view; ///< of the last image
    FramePtr m_frame;
    double m_uploadSeconds = 0; ///< since the last image
    bool m_preparing = false;
    UploadCounts m_uploaded;
    bool m_boxFits = true;
    QTimer m_uploading; ///< runs while a large frame, a detail region, points in the view or a long toolpath
                        ///< is prepared
    QTimer m_rest;      ///< starts again whenever the image changes
    bool m_smooth = false; ///< draw antialiased, although that is slow in software
    double m_plainSeconds = 0;
};

} // namespace proveout
