// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/languages.h"

#include <algorithm>
#include <string_view>

#include <QApplication>
#include <QDir>
#include <QLibraryInfo>
#include <QLocale>
#include <QWidget>

namespace proveout {

namespace {

const QString kCatalogues = QStringLiteral(":/i18n");
const QString kPrefix = QStringLiteral("proveout_");

/// lupdate writes class names into the catalogues without their namespace, but moc includes it.
class OwnTranslator final : public QTranslator {
public:
    [[nodiscard]] QString translate(const char* context, const char* text, const char* note,
                                    int number) const override {
        const std::string_view name(context == nullptr ? "" : context);
        const bool ours = name.starts_with(kNamespace);
        return QTranslator::translate(ours ? context + kNamespace.size() : context, text, note, number);
    }

private:
    static constexpr std::string_view kNamespace = "proveout::";
};

template<class Translator>
std::unique_ptr<QTranslator> installed(const QString& file, const QString& folder) {
    auto translator = std::make_unique<Translator>();
    if (!translator->load(file, folder))
        return nullptr;
    QCoreApplication::installTranslator(translator.get());
    return translator;
}

} // namespace

std::vector<Language> languages() {
    std::vector<Language> found{{QStringLiteral("en"), QStringLiteral("English")}};
    for (const QString& file :
         QDir(kCatalogues).entryList({kPrefix + QStringLiteral("*.qm")}, QDir::Files, QDir::Name)) {
        const QString code = file.mid(kPrefix.size()).chopped(3);
        if (code == found.front().code)
            continue;
        QString name = QLocale(code).nativeLanguageName();
        name[0] = name[0].toUpper();
        found.push_back({code, name});
    }
    return found;
}

QString systemLanguage() {
    const QString code = QLocale::system().name().section(QLatin1Char('_'), 0, 0);
    const std::vector<Language> all = languages();
    const bool known = std::any_of(all.begin(), all.end(), [&](const Language& l) { return l.code == code; });
    return known ? code : QStringLiteral("en");
}

void LanguageSwitch::apply(const QString& code) {
    m_own.reset(); // the destructor of a translator removes it from the application
    m_qt.reset();
    m_current = code;
    // Numbers follow the language: "23,632" has different meanings in English and in German.
    QLocale::setDefault(QLocale(code));
    for (QWidget* window : QApplication::topLevelWidgets())
        window->setLocale(QLocale());
    m_qt = installed<QTranslator>(QStringLiteral("qtbase_") + code,
                                  QLibraryInfo::path(QLibraryInfo::TranslationsPath));
    m_own = installed<OwnTranslator>(kPrefix + code, kCatalogues);
}

} // namespace proveout
