// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>
#include <string>

#include <QTest>

#include "core/base/field.h"
#include "core/base/figures_argument.h"
#include "core/base/list_argument.h"
#include "core/decimation/regions/parameters.h"
#include "core/nc/codes/codes.h"
#include "core/nc/run/interpreter.h"
#include "core/zmap/stock.h"
#include "ui/look/diagnostic_text.h"
#include "ui/look/languages.h"

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
            return std::ranges::find(problem.arguments, Argument("coordinate rotation")) !=
                   problem.arguments.end();
        });
        QVERIFY(found != program->diagnostics().end());
        const QString name = coreText("coordinate rotation");
        QVERIFY(name != QLatin1String("coordinate rotation"));
        QVERIFY2(sentence(*found).contains(name), qPrintable(sentence(*found)));
        QVERIFY(!sentence(*found).contains(QLatin1String("coordinate rotation")));
        QVERIFY(sentence(*found).contains(QLatin1String("G68")));
    }

    void figuresAreWrittenAsTheLanguageDoes() {
        LanguageSwitch languages;
        Diagnostic problem;
        problem.text = "{} mm, {}, {}, {}";
        problem.hint = "{1}";
        problem.arguments = {figures("{:.2f}", 0.25), "X1.5", "part.v2.nc",
                             figures("{:g}x{:g}", 1000.5, -2.5)};
        languages.apply(QStringLiteral("de"));
        QCOMPARE(sentence(problem), QStringLiteral("0,25 mm, X1.5, part.v2.nc, 1000,5x-2,5"));
        QCOMPARE(hint(problem), QStringLiteral("0,25"));
        QCOMPARE(figuresText("1.5 GB"), QStringLiteral("1,5 GB"));
        languages.apply(QStringLiteral("en"));
        QCOMPARE(sentence(problem), QStringLiteral("0.25 mm, X1.5, part.v2.nc, 1000.5x-2.5"));
        QCOMPARE(message(problem), std::string("0.25 mm, X1.5, part.v2.nc, 1000.5x-2.5"));
    }

    /// Figures computed by the core are marked; words of the program are not.
    void messagesOfTheCoreMarkTheirFigures() {
        LanguageSwitch languages;
        languages.apply(QStringLiteral("de"));
        const auto program = interpret(NcText(std::string("G21 G90\nF100 G0 X0 Y0 Z5\nG2 X10 Y0 I4.75 J0\n"
                                                          "G99.7\n")),
                                       {});
        QStringList shown;
        for (const Diagnostic& problem : program->diagnostics())
            shown += sentence(problem);
        const QString all = shown.join(u'\n');
        QVERIFY2(all.contains(QLatin1String("4,75")) && all.contains(QLatin1String("5,25")), qPrintable(all));
        QVERIFY2(!all.contains(QLatin1String("4.75")), qPrintable(all));
        QVERIFY2(all.contains(QLatin1String("G99.7")), qPrintable(all));
        const Result<Grid> grid = makeGrid({{0, 0, 0}, 10.5, 20, 5}, 60.25);
        QVERIFY(!grid);
        QVERIFY2(sentence(grid.error().front()).contains(QLatin1String("60,25")) &&
                     sentence(grid.error().front()).contains(QLatin1String("10,5x20x5")),
                 qPrintable(sentence(grid.error().front())));
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
