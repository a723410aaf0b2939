// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/layout_menu.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <QSettings>

namespace proveout {

namespace {

const QString kLayoutKey = QStringLiteral("window/layout");

} // namespace

LayoutMenu::LayoutMenu(QWidget* parent)
    : QMenu(parent), m_present(&dockLayout(QSettings().value(kLayoutKey).toString().toStdString())) {
    setObjectName(QStringLiteral("layout-menu"));
    setToolTipsVisible(true);
    auto* group = new QActionGroup(this);
    for (const DockLayout& row : dockLayouts()) {
        QAction* action = addAction(QString());
        action->setObjectName(QStringLiteral("layout-") + QLatin1String(row.id));
        action->setCheckable(true);
        action->setChecked(&row == m_present);
        group->addAction(action);
        connect(action, &QAction::triggered, this, [this, &row] { choose(row); });
        m_actions.push_back(action);
    }
    retranslate();
}

void LayoutMenu::retranslate() {
    const std::span<const DockLayout> rows = dockLayouts();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        m_actions[i]->setText(QCoreApplication::translate("Layouts", rows[i].title));
        m_actions[i]->setToolTip(QCoreApplication::translate("Layouts", rows[i].tip));
        m_actions[i]->setStatusTip(m_actions[i]->toolTip());
    }
}

void LayoutMenu::choose(const DockLayout& layout) {
    m_present = &layout;
    QSettings().setValue(kLayoutKey, QLatin1String(layout.id));
    emit chosen(layout);
}

} // namespace proveout
