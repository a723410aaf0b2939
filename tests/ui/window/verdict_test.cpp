// SPDX-License-Identifier: GPL-3.0-or-later
// The verdict in the tool bar.
#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <string>

#include <QApplication>
#include <QDockWidget>
#include <QFile>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "core/cutter/cutter.h"
#include "tests/ui/window/workstation.h"
#include "ui/editor/editor_panel.h"
#include "ui/editor/nc_editor.h"
#include "ui/look/diagnostic_text.h"
#include "ui/look/languages.h"
#include "ui/look/theme.h"

namespace proveout {
namespace {

const QByteArray kHead = "G21 G90 G17\nT1 M6\nS1000 M3\nG43 H1\nG0 X5 Y5 Z5\nG1 Z-2 F100\nX10\n";
const QByteArray kEnd = "G0 Z5\nM30\n";
const QByteArray kFaulty = kHead + "G0 X20\n" + kEnd;

std::set<std::string> everything() {
    std::set<std::string> ids;
    for (const NotCheckedRow& row : notCheckedRows())
        ids.insert(row.id);
    return ids;
}

struct Bench {
    QTemporaryDir folder;
    Workstation station{false};

    /// Opens a text on a stock of 40 × 30 × 10 mm, with a 4 mm ball-end mill.
    void open(const QByteArray& text) {
        const QString name = folder.filePath(QStringLiteral("p.nc"));
        QFile file(name);
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
            qFatal("cannot write the test's own file");
        file.close();
        station.open(name);
        Setup setup = station.session.job().setup();
        setup.stock.width = 40;
        setup.stock.depth = 30;
        setup.stock.height = 10;
        setup.stock.corner = Vec3(0);
        setup.tools.set(1, parseCutter("ball:d=4,l=20").value());
        if (!station.session.job().setSetup(setup))
            qFatal("the setup was refused");
    }
    [[nodiscard]] QToolButton& badge() const {
        return *station.window.findChild<QToolButton*>(QStringLiteral("verdict"));
    }
    [[nodiscard]] QString text() const { return badge().text(); }
    [[nodiscard]] CheckHub& check() { return station.session.check(); }
};

/// The colour that most of a picture has.
QColor mainColor(const QImage& picture) {
    std::map<QRgb, int> counts;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            ++counts[picture.pixel(x, y)];
    return QColor(std::ranges::max_element(counts, {}, [](const auto& each) { return each.second; })->first);
}

} // namespace

class VerdictTest : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings = std::make_unique<OwnSettings>(); }
    void cleanup() { QApplication::setPalette(lightPalette()); }

    void withoutAProgramThereIsNone() {
        Bench bench;
        QVERIFY(!bench.badge().isVisible());
    }

    void itFollowsTheProgram() {
        Bench bench;
        bench.open(kFaulty);
        QVERIFY(bench.badge().isVisible());
        QVERIFY(bench.text().startsWith(QStringLiteral("Checking…")));
        QTRY_COMPARE_WITH_TIMEOUT(bench.text(), QStringLiteral("FAULTS 1"), kPatience);
        QVERIFY2(bench.badge().toolTip().contains(QStringLiteral("Line 8, block 4: ")),
                 qPrintable(bench.badge().toolTip()));
        QCOMPARE(bench.badge().accessibleName(), QStringLiteral("Verdict: FAULTS 1"));
        // It is marked at its block and its line, without being played.
        TimelineScale& scale = bench.station.scale();
        const QPoint mark(static_cast<int>(scale.positionOf(4)), 4);
        QTRY_COMPARE_WITH_TIMEOUT(scale.grab().toImage().pixelColor(mark),
                                  severityColor(meaningColors(scale.palette()), Severity::fault), kPatience);
        QVERIFY(bench.station.window.editor().editor().markersAtLine(7) != 0);
        QVERIFY(bench.station.window.editor().editor().markersAtLine(6) == 0);
        QCOMPARE(bench.station.session.simulation().block(), std::size_t{0});
        // The edit removes the fault; what was not checked remains.
        const auto place = static_cast<std::size_t>(kFaulty.indexOf("G0 X20"));
        bench.station.session.document().applyEdit(place, 2, "G1");
        QVERIFY(bench.text().startsWith(QStringLiteral("Checking…")));
        QTRY_COMPARE_WITH_TIMEOUT(bench.text(), QStringLiteral("UNVERIFIED"), kPatience);
        QVERIFY(bench.badge().toolTip().contains(QStringLiteral("Collisions with fixtures")));
        bench.check().setAccepted(everything());
        QCOMPARE(bench.text(), QStringLiteral("SAFE"));
        QVERIFY2(bench.badge().toolTip().contains(QStringLiteral("Collisions with fixtures")),
                 "what was accepted is named");
    }

    void anUnknownWordIsNamed() {
        Bench bench;
        bench.check().setAccepted(everything());
        bench.open(kHead + "G987\nX20\n" + kEnd);
        QTRY_COMPARE_WITH_TIMEOUT(bench.text(), QStringLiteral("UNVERIFIED"), kPatience);
        QVERIFY2(bench.badge().toolTip().contains(QStringLiteral("Line 8: ")),
                 qPrintable(bench.badge().toolTip()));
    }

    void withoutTheMemoryItSaysSo() {
        Bench bench;
        bench.check().setMemoryLimit(1000);
        bench.open(kFaulty);
        QTRY_VERIFY_WITH_TIMEOUT(bench.text().startsWith(QStringLiteral("Not checked: needs ")), kPatience);
        QVERIFY2(bench.text().endsWith(QStringLiteral(" MB")), qPrintable(bench.text()));
    }

    void aClickShowsTheFindings() {
        Bench bench;
        bench.open(kFaulty);
        auto* dock = bench.station.window.findChild<QDockWidget*>(QStringLiteral("dock-problems"));
        dock->hide();
        QTest::mouseClick(&bench.badge(), Qt::LeftButton);
        QVERIFY(dock->isVisible());
    }

    void itsWordsCanBeReadInEveryLanguageAndTheme() {
        Bench bench;
        bench.open(kFaulty);
        QTRY_COMPARE_WITH_TIMEOUT(bench.text(), QStringLiteral("FAULTS 1"), kPatience);
        for (const Theme theme : {Theme::light, Theme::dark}) {
            bench.station.appearance.setTheme(theme);
            const QPalette palette = QApplication::palette();
            for (const QColor& fill : {meaningColors(palette).error, meaningColors(palette).warning,
                                       meaningColors(palette).safe}) {
                QVERIFY(contrast(fill, palette.color(QPalette::Base)) >= 4.5);
                QVERIFY(contrast(fill, palette.color(QPalette::Window)) >= 3);
            }
            QTRY_COMPARE_WITH_TIMEOUT(mainColor(bench.badge().grab().toImage()), meaningColors(palette).error,
                                      kPatience);
            for (const Language& language : languages()) {
                bench.station.appearance.setLanguage(language.code);
                QTRY_VERIFY2_WITH_TIMEOUT(bench.badge().width() >= bench.badge().sizeHint().width(),
                                          qPrintable(language.code), kPatience);
                for (const NotCheckedRow& row : notCheckedRows())
                    QCOMPARE(coreText(row.title) != QLatin1String(row.title),
                             language.code != QLatin1String("en"));
            }
            bench.station.appearance.setLanguage(QStringLiteral("en"));
        }
    }

private:
    std::unique_ptr<OwnSettings> m_settings;
};

} // namespace proveout

int main(int argc, char** argv) {
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QApplication application(argc, argv);
    proveout::VerdictTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "verdict_test.moc"
