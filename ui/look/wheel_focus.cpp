// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/wheel_focus.h"

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QScrollBar>

namespace proveout {

namespace {

constexpr const char* kMark = "wheelChangesTheValue";

bool isInput(const QWidget& widget) {
    if (qobject_cast<const QScrollBar*>(&widget) != nullptr)
        return false; // the wheel scrolls it
    return qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr ||
           qobject_cast<const QComboBox*>(&widget) != nullptr ||
           qobject_cast<const QAbstractSlider*>(&widget) != nullptr || widget.property(kMark).toBool();
}

bool hasFocusInside(const QWidget& widget) {
    const QWidget* focus = QApplication::focusWidget();
    return focus != nullptr && (focus == &widget || widget.isAncestorOf(focus));
}

/// Qt gives some widgets the focus before they receive the wheel event.
void keepFocusFromWheel(QWidget& widget) {
    if (widget.focusPolicy() == Qt::WheelFocus)
        widget.setFocusPolicy(Qt::StrongFocus);
}

} // namespace

WheelFocus::WheelFocus(QObject* parent) : QObject(parent) {
    for (QWidget* widget : QApplication::allWidgets())
        keepFocusFromWheel(*widget);
    qApp->installEventFilter(this);
}

void WheelFocus::mark(QWidget& input) {
    input.setProperty(kMark, true);
}

bool WheelFocus::eventFilter(QObject* watched, QEvent* event) {
    // Widgets that are created later receive one Polish event before they are first shown.
    if ((event->type() != QEvent::Wheel && event->type() != QEvent::Polish) || !watched->isWidgetType())
        return false;
    auto& widget = static_cast<QWidget&>(*watched);
    if (event->type() == QEvent::Polish) {
        keepFocusFromWheel(widget);
        return false;
    }
    if (!isInput(widget) || hasFocusInside(widget))
        return false;
    event->ignore(); // so that the parent receives it
    return true;
}

} // namespace proveout
