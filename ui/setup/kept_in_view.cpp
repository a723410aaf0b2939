// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/setup/kept_in_view.h"

#include <QEvent>
#include <QLayout>
#include <QScrollArea>
#include <QScrollBar>

namespace proveout {

KeptInView::KeptInView(QScrollArea& area, QWidget& form) : QObject(&area), m_area(area), m_form(form) {
    area.widget()->installEventFilter(this);
    form.installEventFilter(this);
    connect(area.verticalScrollBar(), &QScrollBar::actionTriggered, this, [this] { m_keeps = false; });
}

void KeptInView::keep() {
    m_keeps = true;
    bring();
}

void KeptInView::bring() {
    // If the user is typing elsewhere now, scrolling could move that field out of view.
    QWidget* field = m_form.window()->focusWidget();
    m_keeps = m_keeps && (field == nullptr || m_form.isAncestorOf(field));
    if (!m_keeps)
        return;
    m_area.widget()->layout()->activate(); // a tool that was just added gets its form only here
    m_area.ensureWidgetVisible(&m_form);
    if (field != nullptr)
        m_area.ensureWidgetVisible(field);
}

bool KeptInView::eventFilter(QObject* watched, QEvent* event) {
    const QEvent::Type type = event->type();
    // Queued, because the layouts have not finished yet.
    if (m_keeps && (type == QEvent::Resize || type == QEvent::Move || type == QEvent::LayoutRequest))
        QMetaObject::invokeMethod(this, &KeptInView::bring, Qt::QueuedConnection);
    return QObject::eventFilter(watched, event);
}

} // namespace proveout
