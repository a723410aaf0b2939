// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/panel_docks.h"

#include <algorithm>
#include <utility>

#include <QAction>
#include <QCoreApplication>
#include <QKeySequence>
#include <QMainWindow>

#include "ui/look/icons.h"
#include "ui/session/session.h"
#include "ui/window/dock_titles.h"
#include "ui/window/fitted_dock.h"
#include "ui/window/panel_focus.h"

namespace proveout {

PanelDocks::PanelDocks(QMainWindow& window, QStackedWidget& centre, const PanelParts& parts,
                       std::span<const PanelRow> rows)
    : QObject(&window), m_window(window), m_session(parts.session), m_rows(rows),
      m_focus(new PanelFocus(window, centre)) {
    for (const PanelRow& row : rows)
        add(row, parts);
    std::vector<QDockWidget*> titled;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].titleBar)
            titled.push_back(m_docks[i]);
        if (rows[i].fitted)
            m_fitted = new FittedDock(window, *m_docks[i]);
    }
    new DockTitles(window, std::move(titled));
    retitle();
    connect(&parts.session.document(), &DocumentHub::changed, this, &PanelDocks::retitle);
    connect(&parts.session.problems(), &ProblemsHub::changed, this, &PanelDocks::retitle);
    connect(&parts.session.check(), &CheckHub::changed, this, &PanelDocks::retitle);
}

void PanelDocks::add(const PanelRow& row, const PanelParts& parts) {
    auto* dock = new QDockWidget(&m_window);
    dock->setObjectName(QLatin1String(row.id));
    dock->setWidget(row.make(parts, &m_window));
    if (!row.titleBar)
        dock->setTitleBarWidget(new QWidget(dock));
    QAction* toggle = dock->toggleViewAction();
    toggle->setObjectName(QStringLiteral("show-") + QLatin1String(row.id));
    toggle->setIcon(icon(QLatin1String(row.icon)));
    toggle->setShortcut(QKeySequence(QLatin1String(row.keys)));
    m_focus->add(*dock);
    m_docks.push_back(dock);
}

QDockWidget& PanelDocks::dock(std::string_view id) const {
    const auto found = std::ranges::find(m_rows, id, &PanelRow::id);
    Q_ASSERT(found != m_rows.end());
    return *m_docks[static_cast<std::size_t>(found - m_rows.begin())];
}

QList<QAction*> PanelDocks::actionsOf(PanelMenu menu) const {
    QList<QAction*> actions;
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        if (m_rows[i].menu == menu)
            actions += m_docks[i]->widget()->actions();
    }
    return actions;
}

QList<const QWidget*> PanelDocks::jobPanels() const {
    QList<const QWidget*> panels;
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        if (m_rows[i].editsJob)
            panels << m_docks[i]->widget();
    }
    return panels;
}

void PanelDocks::arrange(const DockLayout& layout) {
    DockLayout all = layout;
    for (const PanelRow& row : m_rows)
        placeUnnamed(all, row.id, row.area);
    arrangeDocks(m_window, all);
    if (m_fitted != nullptr)
        m_fitted->adopt();
}

bool PanelDocks::restore(const QByteArray& state, int version) {
    return m_window.restoreState(state, version);
}

void PanelDocks::show(std::string_view id) {
    dock(id).show();
    dock(id).raise();
}

void PanelDocks::activate(std::string_view id) {
    m_focus->activate(dock(id));
}

void PanelDocks::raiseFloating() {
    for (QDockWidget* dock : m_docks) {
        if (dock->isFloating() && dock->isVisible())
            dock->raise();
    }
}

void PanelDocks::retitle() {
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const QString title = QCoreApplication::translate("Docks", m_rows[i].title);
        m_docks[i]->setWindowTitle(m_rows[i].marked == nullptr ? title : m_rows[i].marked(title, m_session));
    }
}

void PanelDocks::fit() {
    if (m_fitted != nullptr)
        m_fitted->fit();
}

bool PanelDocks::isWidthChosen() const {
    return m_fitted != nullptr && m_fitted->isChosen();
}

void PanelDocks::setWidthChosen(bool chosen) {
    if (m_fitted != nullptr)
        m_fitted->setChosen(chosen);
}

} // namespace proveout
