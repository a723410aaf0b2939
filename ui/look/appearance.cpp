// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/appearance.h"

#include <QSettings>

namespace proveout {

namespace {
const QString kThemeKey = QStringLiteral("theme");
const QString kLanguageKey = QStringLiteral("language");
} // namespace

Appearance::Appearance(QObject* parent) : QObject(parent) {
    const QSettings settings;
    overrideTheme(themeFromKey(settings.value(kThemeKey).toString()));
    overrideLanguage(settings.value(kLanguageKey, systemLanguage()).toString());
}

void Appearance::setTheme(Theme theme) {
    QSettings().setValue(kThemeKey, themeKey(theme));
    overrideTheme(theme);
}

void Appearance::setLanguage(const QString& code) {
    QSettings().setValue(kLanguageKey, code);
    overrideLanguage(code);
}

void Appearance::overrideTheme(Theme theme) {
    m_theme = theme;
    applyTheme(theme);
}

void Appearance::overrideLanguage(const QString& code) {
    m_language.apply(code);
}

} // namespace proveout
