// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

#include "ui/look/languages.h"
#include "ui/look/theme.h"

namespace proveout {

/// Theme and language of the application, stored in the settings.
class Appearance final : public QObject {
    Q_OBJECT

public:
    /// Applies the settings; construct it before the first widget.
    explicit Appearance(QObject* parent = nullptr);

    [[nodiscard]] Theme theme() const { return m_theme; }
    [[nodiscard]] const QString& language() const { return m_language.current(); }
    void setTheme(Theme theme);
    void setLanguage(const QString& code);
    /// For this run only.
    void overrideTheme(Theme theme);
    void overrideLanguage(const QString& code);

private:
    Theme m_theme = Theme::system;
    LanguageSwitch m_language;
};

} // namespace proveout
