// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/escape_key.h"

#include <QApplication>
#include <QKeyEvent>

#include "ui/session/contact_hub.h"

namespace proveout {

EscapeKey::EscapeKey(const ContactHub& contact, QObject* parent) : QObject(parent), m_contact(contact) {
    qApp->installEventFilter(this);
}

bool EscapeKey::eventFilter(QObject*, QEvent* event) {
    if (event->type() != QEvent::ShortcutOverride || !m_contact.isShown() ||
        static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape)
        return false;
    event->ignore(); // leaves the key to the command
    return true;
}

} // namespace proveout
