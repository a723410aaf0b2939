// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/appearance_menus.h"

#include <utility>

#include "ui/look/icons.h"

namespace proveout {

AppearanceMenus::AppearanceMenus(Appearance& appearance, QWidget* parent)
    : QObject(parent), m_appearance(appearance), m_theme(new QMenu(parent)), m_language(new QMenu(parent)),
      m_themes(new QActionGroup(m_theme)), m_languages(new QActionGroup(m_language)) {
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
        add(*m_themes, text, theme == m_appearance.theme(),
            [this, theme = theme] { m_appearance.setTheme(theme); });
    for (const Language& language : languages())
        add(*m_languages, language.name, language.code == m_appearance.language(),
            [this, code = language.code] { m_appearance.setLanguage(code); });
}

void AppearanceMenus::add(QActionGroup& group, const QString& text, bool checked,
                          std::function<void()> choose) {
    QAction* action = static_cast<QMenu*>(group.parent())->addAction(text);
    group.addAction(action);
    action->setCheckable(true);
    action->setChecked(checked);
    // Queued, because a change of language fills this menu again.
    connect(action, &QAction::triggered, this, std::move(choose), Qt::QueuedConnection);
}

} // namespace proveout
