// SPDX-License-Identifier: GPL-3.0-or-later
// What mouse and keys do in the 3D view.
#include <cmath>
#include <utility>

#include <QApplication>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QStatusTipEvent>
#include <QWheelEvent>

#include "ui/probe_text.h"
#include "ui/surface_probe.h"
#include "ui/viewport/closer_look_form.h"
#include "ui/viewport/place_label.h"
#include "ui/viewport/surface_pick.h"
#include "ui/viewport/viewport.h"

namespace proveout {
namespace {

constexpr double kZoomPerStep = 0.85; ///< of a wheel, 120 units of angle
constexpr double kKeyOrbitPixels = 40;

} // namespace

// --- from a place to its block

void Viewport::toggleBlockSearch() {
    if (m_choosing == Choosing::place)
        return choose(Choosing::nothing);
    if (m_choosing == Choosing::box && !m_look.box())
        closeLook();
    choose(Choosing::place);
    QStatusTipEvent tip(tr("Click a point on the stock."));
    QApplication::sendEvent(this, &tip);
}

void Viewport::askWhatMade(const QPointF& position) {
    const QPointF pixel = position * devicePixelRatioF();
    m_session.navigation().goToBlockThatMade(
        pickPlace(m_frame, m_look.picture(), m_camera.ray(pixel.x(), pixel.y())));
}

void Viewport::openMenu(const QPointF& position) {
    m_placeLabel->hide();
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    // The command of the menu bar asks for a click; here the place is known.
    const QAction* command = m_commands->find("go-to-block");
    connect(menu->addAction(command->text() + QLatin1Char('\t') + tr("Ctrl+click")), &QAction::triggered,
            this, [this, position] { askWhatMade(position); });
    for (QAction* action : actions()) {
        if (action->objectName() == QLatin1String("jump-back"))
            menu->addAction(action);
    }
    menu->popup(mapToGlobal(position.toPoint()));
}

void Viewport::contextMenuEvent(QContextMenuEvent* event) {
    // Of the mouse a click opens it, not the press that may become a drag.
    if (event->reason() != QContextMenuEvent::Mouse)
        openMenu(event->pos());
    event->accept();
}

// --- the place under the pointer

void Viewport::hover(const QPointF& position) {
    m_hover = position;
    probeAgain();
}

/// With the next tick, as all of the window: the status line tells the place too.
void Viewport::probeAgain() {
    if (m_hover)
        m_session.playback().requestTick();
}

void Viewport::probeSurface() {
    std::optional<SurfacePlace> place;
    if (m_hover) {
        const QPointF pixel = *m_hover * devicePixelRatioF();
        place = pickSurface(m_frame, m_look.picture(), m_camera.ray(pixel.x(), pixel.y()));
    }
    if (place || m_probe->place())
        m_probe->point(place, m_frame != nullptr && m_frame->program == m_session.program().current());
    showPlace();
}

void Viewport::showPlace() {
    const bool busy = m_gesture != Gesture::none || m_choice || QApplication::activePopupWidget() != nullptr;
    if (!m_placeLabelShown || !m_hover || !m_probe->place() || busy || !isActiveWindow())
        return m_placeLabel->hide();
    const QString cut = cutText(*m_probe);
    const QString position = positionText(*m_probe, locale());
    m_placeLabel->showAt(mapToGlobal(m_hover->toPoint()), cut.isEmpty() ? position : position + u'\n' + cut);
}

void Viewport::leaveEvent(QEvent* event) {
    QOpenGLWidget::leaveEvent(event);
    m_placeLabel->hide();
    probeAgain();
    m_hover.reset();
}

void Viewport::hideEvent(QHideEvent* event) {
    m_placeLabel->hide();
    QOpenGLWidget::hideEvent(event);
}

// --- the user's gestures

Vec3 Viewport::under(const QPointF& position) const {
    const QPointF pixel = position * devicePixelRatioF();
    if (m_frame != nullptr)
        if (const auto hit = pickStock(m_frame->zmap, m_camera.ray(pixel.x(), pixel.y())))
            return *hit;
    return m_camera.atTargetDepth(pixel.x(), pixel.y());
}

void Viewport::mousePressEvent(QMouseEvent* event) {
    if (m_choosing == Choosing::box && m_frame != nullptr && event->button() == Qt::LeftButton &&
        event->modifiers() == Qt::NoModifier) {
        beginChoice(event->position());
        return;
    }
    m_pressed.reset();
    if (isClick(*event))
        m_pressed = event->position();
    m_gesture = gestureFor(event->button(), event->modifiers());
    m_last = event->position();
    m_placeLabel->hide();
}

/// Whether what begins with it means something if it stays a click.
bool Viewport::isClick(const QMouseEvent& event) const {
    if (event.buttons() != event.button())
        return false;
    if (event.button() == Qt::RightButton)
        return event.modifiers() == Qt::NoModifier;
    const bool plain = event.modifiers() == Qt::NoModifier;
    return event.button() == Qt::LeftButton &&
           (event.modifiers() == Qt::ControlModifier || (plain && m_choosing == Choosing::place));
}

void Viewport::clicked(Qt::MouseButton button, const QPointF& position) {
    if (button == Qt::RightButton)
        return openMenu(position);
    if (m_choosing == Choosing::place)
        choose(Choosing::nothing);
    askWhatMade(position);
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
    hover(event->position());
    if (m_pressed && (event->position() - *m_pressed).manhattanLength() >= QApplication::startDragDistance())
        m_pressed.reset();
    if (m_choice) {
        const QPointF pixel = event->position() * devicePixelRatioF();
        m_choice->dragTo({pixel.x(), pixel.y()}, m_camera.ray(pixel.x(), pixel.y()));
        repaintSoon();
        return;
    }
    if (m_gesture == Gesture::none)
        return;
    const QPointF drag = (event->position() - m_last) * devicePixelRatioF();
    m_last = event->position();
    if (m_gesture == Gesture::orbit)
        m_camera.orbit(drag.x(), drag.y());
    else
        m_camera.pan(drag.x(), drag.y());
    moved();
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
    m_gesture = Gesture::none;
    hover(event->position());
    if (std::exchange(m_pressed, std::nullopt))
        return clicked(event->button(), event->position());
    if (!m_choice || event->button() != Qt::LeftButton)
        return;
    const BoxOfInterest box{m_choice->box(m_frame->zmap.stock(), m_form->size()), m_form->spacing()};
    m_choice.reset();
    choose(Choosing::nothing);
    m_look.look(box);
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() != Qt::MiddleButton)
        return;
    m_camera.setTarget(under(event->position()));
    moved();
}

void Viewport::wheelEvent(QWheelEvent* event) {
    const double steps = event->angleDelta().y() / double{QWheelEvent::DefaultDeltasPerStep};
    if (steps != 0) {
        m_camera.zoom(std::pow(kZoomPerStep, steps), under(event->position()));
        moved();
    }
    event->accept();
}

void Viewport::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && m_choosing == Choosing::place)
        return choose(Choosing::nothing);
    if (event->key() == Qt::Key_Escape && looksCloser()) {
        closeLook();
        return;
    }
    const bool turn = (event->modifiers() & Qt::AltModifier) != 0;
    const double dx = (event->key() == Qt::Key_Right) - (event->key() == Qt::Key_Left);
    const double dy = (event->key() == Qt::Key_Down) - (event->key() == Qt::Key_Up);
    if (!turn || (dx == 0 && dy == 0)) {
        QOpenGLWidget::keyPressEvent(event);
        return;
    }
    m_camera.orbit(dx * kKeyOrbitPixels, dy * kKeyOrbitPixels);
    moved();
}

} // namespace proveout
