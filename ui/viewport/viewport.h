// SPDX-License-Identifier: GPL-3.0-or-later
// The stock in 3D: a widget for ui/gl's scene renderer.
#pragma once

#include <memory>

#include <QOpenGLWidget>

#include "ui/gl/gl_functions.h"
#include "ui/look/command_table.h"
#include "ui/session/session.h"
#include "ui/viewport/camera.h"
#include "ui/viewport/camera_gestures.h"
#include "ui/viewport/closer_look.h"
#include "ui/viewport/scene_picture.h"

namespace proveout {

class ContactView;
class DetailChoice;
class PartView;
class PointerPlace;

/// The 3D view of a session, with its commands as actions() of the widget. If OpenGL is not available, a
/// plain message replaces it and the rest of the window still works. Owned by `parent`. Thread: UI.
[[nodiscard]] QWidget* createViewport(Session& session, QWidget* parent = nullptr);
/// The same with a given result of probeGl().
[[nodiscard]] QWidget* createViewport(Session& session, const GlSupport& support, QWidget* parent);

/// Repaints only in the session's tick and on user input, and reports the cost of uploading and drawing to
/// the session. A child SurfaceProbe follows the pointer in the same ticks.
class Viewport : public QOpenGLWidget {
    Q_OBJECT

public:
    Viewport(Session& session, const GlSupport& support, QWidget* parent = nullptr);
    ~Viewport() override;

    [[nodiscard]] const Camera& camera() const { return m_camera; }
    [[nodiscard]] const SceneOptions& options() const { return m_options; }
    /// Adopts everything except the colours, which follow the palette.
    void setOptions(const SceneOptions& options);
    [[nodiscard]] bool legendShown() const { return m_legend; }
    void setLegendShown(bool shown);
    /// Whether a label next to the pointer shows the position under it.
    [[nodiscard]] bool placeLabelShown() const;
    void setPlaceLabelShown(bool shown);
    /// What is drawn, and the graphics memory for it.
    [[nodiscard]] ScenePicture& picture() { return *m_picture; }
    void setStandardView(StandardView view);
    void setPerspective(bool perspective);
    /// Fits the stock into the view, or the toolpath if there is no stock.
    void fit();
    /// Shows the present tool again instead of a contact.
    void hideContact() { m_session.contact().clear(); }
    /// Lets the user choose a detail region, or closes the existing one.
    void toggleCloserLook();
    /// Starts or ends the mode in which a click on the stock goes to the block that cut that position.
    void toggleBlockSearch();
    /// Whether the user is choosing a detail region, or one exists.
    [[nodiscard]] bool looksCloser() const;
    [[nodiscard]] CloserLook& closerLook() { return m_look; }
    /// The uploads of the last image.
    [[nodiscard]] const UploadCounts& uploaded() const { return m_picture->uploaded(); }
    /// Whether no better image of the current content is pending, so that the image stays until something
    /// changes.
    [[nodiscard]] bool atRest() const { return m_picture->atRest(); }

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
    /// What the next click or drag selects.
    enum class Choosing : std::uint8_t { nothing, box, place };

    void onTick(const FramePtr& frame);
    void setFrame(const FramePtr& frame);
    void followPalette();
    void followOptions();
    void setPicture();
    void moved();
    void repaintSoon() { m_picture->repaintSoon(); }
    /// Whether there is a stock to show and to pick from.
    [[nodiscard]] bool hasStock() const { return m_frame != nullptr && m_frame->zmap.tileCount() > 0; }
    void limitZoom();
    [[nodiscard]] QPointF pixelOf(const QPointF& position) const { return position * devicePixelRatioF(); }
    [[nodiscard]] Ray rayAt(const QPointF& position) const;
    [[nodiscard]] Vec3 under(const QPointF& position) const;
    void paintOver(const View& view);
    void closeLook();
    void followLook();
    void choose(Choosing what);
    void clicked(Qt::MouseButton button, const QPointF& position);
    void askWhatMade(const QPointF& position);
    void openMenu(const QPointF& position);

    Session& m_session;
    Camera m_camera;
    SceneOptions m_options;
    bool m_legend = true;
    FramePtr m_frame;
    StockBox m_fittedStock;
    bool m_fitted = false; ///< m_fittedStock has been fitted
    bool m_fits = false;   ///< the view is unchanged since fit(), so resizing the widget fits it again
    CloserLook m_look;
    Choosing m_choosing = Choosing::nothing;
    DetailChoice* m_detail;
    PointerPlace* m_place;
    PartView* m_part;
    std::unique_ptr<ScenePicture> m_picture; ///< destroyed before what it draws and before the context
    CameraDrag m_drag;
    ContactView* m_contact;
    std::optional<QPointF> m_pressed; ///< start of a click that has not become a drag
    std::unique_ptr<CommandActions<Viewport>> m_commands;
};

} // namespace proveout
