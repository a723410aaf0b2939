// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/space_key.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>

namespace proveout {

SpaceKey::SpaceKey(QObject* parent) : QObject(parent) {
    qApp->installEventFilter(this);
}

bool SpaceKey::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space &&
        (qobject_cast<QAbstractButton*>(watched) != nullptr || qobject_cast<QComboBox*>(watched) != nullptr ||
         qobject_cast<QAbstractItemView*>(watched) != nullptr)) {
        event->accept();
        return true;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace proveout
