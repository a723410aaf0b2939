// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/appearance_menus.h"

#include <utility>

#include <QActionGroup>

#include "ui/look/icons.h"

namespace proveout {

AppearanceMenus::AppearanceMenus(Appearance& appearance, QWidget* parent)
    : QObject(parent), m_appearance(appearance), m_theme(new QMenu(parent)), m_language(new QMenu(parent)) {
    m_theme->setIcon(icon(QStringLiteral("theme")));
    m_language->setIcon(icon(QStringLiteral("language")));
    fill();
}

void AppearanceMenus::fill() {
    for (QMenu* menu : {m_theme, m_language})
        menu->clear();
    for (const auto& [theme, text] :
         {std::pair(Theme::system, tr("Same as &System")), std::pair(Theme::light, tr("&Light")),
          std::pair(Theme::dark, tr("&Dark"))})
        add(*m_theme, text, theme == m_appearance.theme(),
            [this, theme = theme] { m_appearance.setTheme(theme); });
    for (const Language& language : languages())
        add(*m_language, language.name, language.code == m_appearance.language(),
            [this, code = language.code] { m_appearance.setLanguage(code); });
    for (QMenu* menu : {m_theme, m_language}) {
        auto* group = new QActionGroup(menu);
        for (QAction* action : menu->actions())
            group->addAction(action);
    }
}

void AppearanceMenus::add(QMenu& menu, const QString& text, bool checked, std::function<void()> choose) {
    QAction* action = menu.addAction(text);
    action->setCheckable(true);
    action->setChecked(checked);
    // Queued, because a change of language fills this menu again.
    connect(action, &QAction::triggered, this, std::move(choose), Qt::QueuedConnection);
}

} // namespace proveout
