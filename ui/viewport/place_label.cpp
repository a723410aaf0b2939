// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/place_label.h"

#include <QGuiApplication>
#include <QScreen>

namespace proveout {
namespace {

constexpr QPoint kBeside(18, 22); ///< px from the pointer, so that its arrow does not cover the text
constexpr int kPadding = 4;

} // namespace

PlaceLabel::PlaceLabel(QWidget* parent)
    : QLabel(parent, Qt::ToolTip | Qt::FramelessWindowHint | Qt::WindowTransparentForInput) {
    setAttribute(Qt::WA_ShowWithoutActivating);
    setFocusPolicy(Qt::NoFocus);
    setTextFormat(Qt::PlainText);
    setBackgroundRole(QPalette::ToolTipBase);
    setForegroundRole(QPalette::ToolTipText);
    setAutoFillBackground(true);
    setFrameShape(QFrame::Box);
    setMargin(kPadding);
}

void PlaceLabel::showAt(const QPoint& pointer, const QString& text) {
    setText(text);
    adjustSize();
    QPoint corner = pointer + kBeside;
    const QScreen* screen = QGuiApplication::screenAt(pointer);
    const QRect area = screen != nullptr ? screen->availableGeometry() : QRect();
    if (screen != nullptr && corner.x() + width() > area.right())
        corner.setX(pointer.x() - kBeside.x() - width());
    if (screen != nullptr && corner.y() + height() > area.bottom())
        corner.setY(pointer.y() - kBeside.y() - height());
    move(corner);
    show();
}

} // namespace proveout
