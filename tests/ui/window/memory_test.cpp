// SPDX-License-Identifier: GPL-3.0-or-later
// The choice of graphics memory reaches the view, and is restored after a restart.
#include <memory>
#include <utility>

#include <QMenu>
#include <QTest>

#include "tests/ui/window/workstation.h"
#include "ui/viewport/viewport.h"

namespace proveout {
namespace {

QList<QAction*> choicesOf(Workstation& station, const char* menu) {
    auto* choices = station.window.findChild<QMenu*>(QLatin1String(menu));
    if (choices == nullptr)
        return {};
    emit choices->aboutToShow();
    return choices->actions();
}

void write(const QString& path, const QByteArray& text) {
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
        qFatal("cannot write the test's own file");
}

/// The index of the only choice with a check mark; -1 if there is no such choice.
qsizetype chosen(const QList<QAction*>& choices) {
    qsizetype found = -1;
    for (qsizetype k = 0; k < choices.size(); ++k)
        if (choices[k]->isChecked() && std::exchange(found, k) != -1)
            return -1;
    return found;
}

} // namespace

class MemoryTest : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings = std::make_unique<OwnSettings>(); }
    void choicesAreKept();
    void graphicsMemoryReachesTheView();

private:
    std::unique_ptr<OwnSettings> m_settings;
};

void MemoryTest::choicesAreKept() {
    for (const char* menu : {"checkpoint-menu", "graphics-memory-menu"}) {
        {
            Workstation station(false);
            const QList<QAction*> choices = choicesOf(station, menu);
            QVERIFY(choices.size() > 2);
            QVERIFY(choices[chosen(choices)]->text().contains(QStringLiteral("default")));
            choices.front()->trigger();
            QCOMPARE(chosen(choicesOf(station, menu)), 0);
        }
        Workstation again(false);
        QCOMPARE(chosen(choicesOf(again, menu)), 0);
    }
}

void MemoryTest::graphicsMemoryReachesTheView() {
    QSettings().setValue(QStringLiteral("view/graphics-megabytes"), 1);
    Workstation station(false);
    const QTemporaryDir folder;
    write(folder.filePath(QStringLiteral("slot.nc")),
          "G21 G90\nM3 S1000\nG0 X10 Y10 Z5\nG1 Z-3 F500\nX150\nM30\n");
    const QString job = folder.filePath(QStringLiteral("slot.proveout"));
    write(job, R"({"proveout":2,"program":"slot.nc","stock":{"minX":0,"minY":0,"topZ":0,"width":200,)"
               R"("depth":200,"height":20},"grid":0.25,"tools":{"1":"flat:d=10"}})");
    station.open(job);
    auto* view = qobject_cast<Viewport*>(&station.window.viewport());
    if (view == nullptr)
        QSKIP("no OpenGL 3.3 here");
    const Grid& grid = station.session.simulation().frame()->zmap.grid();
    QVERIFY(4.0 * grid.nx * grid.ny > 2e6);
    QTRY_VERIFY_WITH_TIMEOUT(view->picture().isCoarser(), kPatience);
    QVERIFY(view->picture().memoryHeld() <= 1'000'000);
    choicesOf(station, "graphics-memory-menu").front()->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(!view->picture().isCoarser() && view->picture().memoryHeld() > 2'000'000,
                             kPatience);
}

} // namespace proveout

QTEST_MAIN(proveout::MemoryTest)
#include "memory_test.moc"
