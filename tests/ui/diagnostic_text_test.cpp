// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>
#include <string>

#include <QTest>

#include "core/base/field.h"
#include "core/base/list_argument.h"
#include "core/decimation/regions/parameters.h"
#include "core/nc/codes/codes.h"
#include "core/nc/run/interpreter.h"
#include "ui/diagnostic_text.h"
#include "ui/languages.h"

namespace proveout {

class DiagnosticTextTest : public QObject {
    Q_OBJECT

private slots:
    void cleanup() { LanguageSwitch().apply(QStringLiteral("en")); }

    void textsOfTheCoreAreTranslatedWithinSentences_data() {
        QTest::addColumn<QString>("language");
        QTest::newRow("de") << QStringLiteral("de");
        QTest::newRow("ko") << QStringLiteral("ko");
    }
    void textsOfTheCoreAreTranslatedWithinSentences() {
        QFETCH(QString, language);
        LanguageSwitch languages;
        languages.apply(language);
        const auto program = interpret(NcText(std::string("G21 G90\nG68 X0 Y0 R30\n")), {});
        const auto found = std::ranges::find_if(program->diagnostics(), [](const Diagnostic& problem) {
            return std::ranges::find(problem.arguments, "coordinate rotation") != problem.arguments.end();
        });
        QVERIFY(found != program->diagnostics().end());
        const QString name = coreText("coordinate rotation");
        QVERIFY(name != QLatin1String("coordinate rotation"));
        QVERIFY2(sentence(*found).contains(name), qPrintable(sentence(*found)));
        QVERIFY(!sentence(*found).contains(QLatin1String("coordinate rotation")));
        QVERIFY(sentence(*found).contains(QLatin1String("G68")));
    }

    void wordsOfTheUserAndKeysStay() {
        LanguageSwitch languages;
        languages.apply(QStringLiteral("de"));
        Diagnostic problem;
        problem.text = "{} {} {}";
        problem.arguments = {"G68", "rotation", std::string("scaling\0x", 9)};
        QVERIFY(sentence(problem).startsWith(QLatin1String("G68 rotation scaling")));
        problem.arguments = {listArgument({"Shape", "Flute length"}), "Shape, Flute length", "l"};
        QCOMPARE(sentence(problem), QStringLiteral("Form, Schneidenlänge Shape, Flute length l"));
        DecimationParameters parameters;
        describe(parameters, [](const auto&, const Field& field) {
            QCOMPARE(coreText(field.key), QLatin1String(field.key));
            for (const Choice& choice : field.choices)
                QCOMPARE(coreText(choice.key), QLatin1String(choice.key));
        });
    }
};

} // namespace proveout

QTEST_MAIN(proveout::DiagnosticTextTest)
#include "diagnostic_text_test.moc"
