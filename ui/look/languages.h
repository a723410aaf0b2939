// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include <QString>
#include <QTranslator>

namespace proveout {

struct Language {
    QString code; ///< "en", "ko", …
    QString name; ///< in the language itself
};

/// English and every language that has a catalogue `:/i18n/proveout_<code>.qm`, sorted by code.
[[nodiscard]] std::vector<Language> languages();

/// The system language if there is a catalogue for it, otherwise English.
[[nodiscard]] QString systemLanguage();

/// Translates the application; widgets receive a LanguageChange event. Owns the translators.
class LanguageSwitch {
public:
    void apply(const QString& code);
    [[nodiscard]] const QString& current() const { return m_current; }

private:
    QString m_current = QStringLiteral("en");
    std::unique_ptr<QTranslator> m_own;
    std::unique_ptr<QTranslator> m_qt; ///< for Qt's standard buttons and dialogs
};

} // namespace proveout
