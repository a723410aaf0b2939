// SPDX-License-Identifier: GPL-3.0-or-later
// The stock in 3D: a widget round ui/gl's scene renderer.
#pragma once

#include <memory>

#include <QOpenGLWidget>
#include <QPen>
#include <QPolygonF>
#include <QTimer>

#include "ui/command_table.h"
#include "ui/gl/gl_functions.h"
#include "ui/gl/scene_renderer.h"
#include "ui/session/session.h"
#include "ui/viewport/box_choice.h"
#include "ui/viewport/camera.h"
#include "ui/viewport/closer_look.h"
#include "ui/viewport/navigation.h"

class QOpenGLFramebufferObject;

namespace proveout {

class CloserLookForm;
class PlaceLabel;
class SurfaceProbe;

/// The 3D view of a session, with its commands as actions() of the widget; where OpenGL is not to be had, a
/// plain message that stands for it: the rest of the window works on. Owned by `parent`. Thread: UI.
[[nodiscard]] QWidget* createViewport(Session& session, QWidget* parent = nullptr);
/// The same with a given answer of probeGl().
[[nodiscard]] QWidget* createViewport(Session& session, const GlSupport& support, QWidget* parent);

/// Repaints in the session's tick and on the user's gestures only, and tells the session what uploading and
/// drawing took. A SurfaceProbe among its children follows the pointer, in the same ticks.
class Viewport : public QOpenGLWidget {
    Q_OBJECT

public:
    Viewport(Session& session, const GlSupport& support, QWidget* parent = nullptr);
    ~Viewport() override;

    [[nodiscard]] const Camera& camera() const { return m_camera; }
    [[nodiscard]] const SceneOptions& options() const { return m_options; }
    /// Takes everything but the colours, which follow the palette.
    void setOptions(const SceneOptions& options);
    [[nodiscard]] bool legendShown() const { return m_legend; }
    void setLegendShown(bool shown);

    /// Whether the place under the pointer is told beside it.
    [[nodiscard]] bool placeLabelShown() const { return m_placeLabelShown; }
    void setPlaceLabelShown(bool shown);

    void setStandardView(StandardView view);
    void setPerspective(bool perspective);
    /// The stock into the picture; the toolpath where there is no stock.
    void fit();
    /// Lets the user choose a box of interest, or closes the one that there is.
    void toggleCloserLook();
    /// Lets the user click a place of the stock to go to the block that made it, or no longer.
    void toggleBlockSearch();
    /// A choice is asked for, or a box is there.
    [[nodiscard]] bool looksCloser() const;
    [[nodiscard]] CloserLook& closerLook() { return m_look; }
    /// Uploads of the last picture.
    [[nodiscard]] const UploadCounts& uploaded() const { return m_uploaded; }
    /// No better picture of what is shown is due: it stays until something changes.
    [[nodiscard]] bool atRest() const { return !m_rest.isActive(); }

protected:
    void initializeGL() override;
    void paintGL() override;
    void resizeGL(int width, int height) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    /// What the next click or drag chooses.
    enum class Choosing : std::uint8_t { nothing, box, place };

    void onTick(const FramePtr& frame);
    void setFrame(const FramePtr& frame);
    void releaseGl();
    void followPalette();
    void followOptions();
    void setPicture();
    void moved();
    void limitZoom();
    void leaveTheSolid();
    void repaintSoon();
    [[nodiscard]] Vec3 under(const QPointF& position) const;
    [[nodiscard]] Box3 sceneBox() const;
    [[nodiscard]] bool showsHiddenPath() const;
    [[nodiscard]] bool workPending() const;
    void goOnUploading();
    void drawScene(const View& view);
    void drawSmooth(const View& view);
    void paintOverlay(const View& view);
    void paintChoice(QPainter& painter) const;
    void paintBoxUnderWay(QPainter& painter) const;
    [[nodiscard]] QPolygonF outlineOf(const PlanBox& box, double level) const;
    [[nodiscard]] QPen boxPen(Qt::PenStyle style) const;
    void closeLook();
    void followForm();
    void followLook();
    void placeForm();
    void beginChoice(const QPointF& position);
    void choose(Choosing what);
    [[nodiscard]] bool isClick(const QMouseEvent& event) const;
    void clicked(Qt::MouseButton button, const QPointF& position);
    void askWhatMade(const QPointF& position);
    void openMenu(const QPointF& position);
    void hover(const QPointF& position);
    void probeAgain();
    void probeSurface();
    void showPlace();

    Session& m_session;
    GlSupport m_support;
    Camera m_camera;
    SceneOptions m_options;
    bool m_legend = true;
    FramePtr m_frame;
    StockBox m_fittedStock;
    bool m_fitted = false; ///< m_fittedStock is the one that was fitted
    bool m_fits = false;   ///< the view is as fit() left it: another size of the widget fits again

    CloserLook m_look;
    CloserLookForm* m_form;
    bool m_boxFits = true;
    Choosing m_choosing = Choosing::nothing;
    std::optional<BoxChoice> m_choice; ///< while it is drawn

    std::optional<QPointF> m_hover; ///< the pointer, while it is over the view
    SurfaceProbe* m_probe;
    PlaceLabel* m_placeLabel;
    bool m_placeLabelShown = true;

    Gesture m_gesture = Gesture::none;
    QPointF m_last;
    std::optional<QPointF> m_pressed; ///< where a click has begun that has not become a drag

    std::unique_ptr<SceneRenderer> m_renderer;
    std::unique_ptr<QOpenGLFramebufferObject> m_smoothTarget;
    UploadCounts m_uploaded;
    QTimer m_uploading;    ///< runs while a box of interest or a long toolpath is prepared
    QTimer m_rest;         ///< the picture has not changed for a moment
    bool m_smooth = false; ///< draw with smoothed edges, although software takes long for it
    double m_plainSeconds = 0;

    std::unique_ptr<CommandActions<Viewport>> m_commands;
};

} // namespace proveout
