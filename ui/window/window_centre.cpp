// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/window_centre.h"

#include <QStackedWidget>
#include <QVBoxLayout>

#include "ui/viewport/viewport.h"
#include "ui/window/start_page.h"

namespace proveout {

WindowCentre::WindowCentre(Session& session, Appearance& appearance, RecentFiles& recent, QWidget* parent)
    : QWidget(parent), m_pages(new QStackedWidget(this)),
      m_startPage(new StartPage(appearance, recent, this)), m_viewport(createViewport(session, this)) {
    m_pages->addWidget(m_startPage);
    m_pages->addWidget(m_viewport);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_pages, 1);
}

void WindowCentre::addNotice(QWidget* notice) {
    static_cast<QBoxLayout*>(layout())->insertWidget(0, notice);
}

} // namespace proveout
