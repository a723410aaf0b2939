// SPDX-License-Identifier: GPL-3.0-or-later
// Mouse and keyboard input of the 3D view.
#include <utility>

#include <QApplication>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QStatusTipEvent>
#include <QWheelEvent>

#include "ui/viewport/detail_choice.h"
#include "ui/viewport/pointer_place.h"
#include "ui/viewport/surface_pick.h"
#include "ui/viewport/viewport.h"

namespace proveout {
namespace {

/// Whether this press has a meaning if it stays a click. `choosing`: the user is choosing a position.
bool mayBeClick(const QMouseEvent& event, bool choosing) {
    if (event.buttons() != event.button())
        return false;
    const bool plain = event.modifiers() == Qt::NoModifier;
    if (event.button() == Qt::RightButton)
        return plain;
    return event.button() == Qt::LeftButton &&
           (event.modifiers() == Qt::ControlModifier || (plain && choosing));
}

} // namespace

// --- from a position to its block

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
    m_session.navigation().goToBlockThatMade(pickPlace(m_frame, m_look.picture(), rayAt(position)));
}

void Viewport::openMenu(const QPointF& position) {
    m_place->hideLabel();
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    // The command in the menu bar asks for a click; here the position is known.
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
    // With the mouse, a click opens it and not the press, because that may become a drag.
    if (event->reason() != QContextMenuEvent::Mouse)
        openMenu(event->pos());
    event->accept();
}

void Viewport::leaveEvent(QEvent* event) {
    QOpenGLWidget::leaveEvent(event);
    m_place->leave();
}

void Viewport::hideEvent(QHideEvent* event) {
    m_place->hideLabel();
    QOpenGLWidget::hideEvent(event);
}

// --- user input

Ray Viewport::rayAt(const QPointF& position) const {
    const QPointF pixel = pixelOf(position);
    return m_camera.ray(pixel.x(), pixel.y());
}

Vec3 Viewport::under(const QPointF& position) const {
    if (m_frame != nullptr)
        if (const auto hit = pickStock(m_frame->zmap, rayAt(position)))
            return *hit;
    const QPointF pixel = pixelOf(position);
    return m_camera.atTargetDepth(pixel.x(), pixel.y());
}

void Viewport::mousePressEvent(QMouseEvent* event) {
    if (m_choosing == Choosing::box && m_frame != nullptr && event->button() == Qt::LeftButton &&
        event->modifiers() == Qt::NoModifier) {
        const QPointF pixel = pixelOf(event->position());
        m_detail->begin({pixel.x(), pixel.y()}, rayAt(event->position()));
        return repaintSoon();
    }
    m_pressed.reset();
    if (mayBeClick(*event, m_choosing == Choosing::place))
        m_pressed = event->position();
    m_drag.begin(event->button(), event->modifiers(), pixelOf(event->position()));
    m_place->hideLabel();
}

void Viewport::clicked(Qt::MouseButton button, const QPointF& position) {
    if (button == Qt::RightButton)
        return openMenu(position);
    if (m_choosing == Choosing::place)
        choose(Choosing::nothing);
    askWhatMade(position);
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
    m_place->hover(event->position());
    if (m_pressed && (event->position() - *m_pressed).manhattanLength() >= QApplication::startDragDistance())
        m_pressed.reset();
    if (m_detail->isDragged()) {
        const QPointF pixel = pixelOf(event->position());
        m_detail->dragTo({pixel.x(), pixel.y()}, rayAt(event->position()));
        repaintSoon();
    } else if (m_drag.dragTo(pixelOf(event->position()), m_camera)) {
        moved();
    }
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
    m_drag.end();
    m_place->hover(event->position());
    if (std::exchange(m_pressed, std::nullopt))
        return clicked(event->button(), event->position());
    if (!m_detail->isDragged() || event->button() != Qt::LeftButton)
        return;
    choose(Choosing::nothing);
    m_detail->finish();
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() != Qt::MiddleButton)
        return;
    m_camera.setTarget(under(event->position()));
    moved();
}

void Viewport::wheelEvent(QWheelEvent* event) {
    const int angle = event->angleDelta().y();
    if (angle != 0) {
        zoomByWheel(m_camera, angle, under(event->position()));
        moved();
    }
    event->accept();
}

void Viewport::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && m_choosing == Choosing::place)
        return choose(Choosing::nothing);
    if (event->key() == Qt::Key_Escape && looksCloser())
        return closeLook();
    if (turnByKey(m_camera, *event))
        moved();
    else
        QOpenGLWidget::keyPressEvent(event);
}

} // namespace proveout
