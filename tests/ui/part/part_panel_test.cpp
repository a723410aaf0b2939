// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/part/part_panel.h"

#include <filesystem>
#include <string>

#include <QFile>
#include <QLabel>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QTreeView>

#include "core/formats/stl.h"
#include "tests/ui/opened.h"
#include "ui/document/file_paths.h"
#include "ui/look/number_box.h"
#include "ui/part/deviation_chart.h"
#include "ui/part/islands_model.h"
#include "ui/part/part_form.h"
#include "ui/part/part_text.h"

namespace proveout {
namespace {

constexpr int kPatience = 20'000; ///< ms

/// A hole 3 mm deep (line 6), then a deeper one (line 9).
const QByteArray kProgram = "G21 G90 G17\nT1 M6\nS1000 M3\nG43 H1\nG0 X10 Y10 Z5\nG1 Z-3 F100\nG0 Z5\n"
                            "X20\nG1 Z-4 F100\nG0 Z5\nM30\n";

TriangleMesh boxMesh(const Vec3& lo, const Vec3& hi) {
    TriangleMesh box;
    for (int k = 0; k < 8; ++k)
        box.vertices.emplace_back((k & 1) != 0 ? hi.x : lo.x, (k & 2) != 0 ? hi.y : lo.y,
                                  (k & 4) != 0 ? hi.z : lo.z);
    box.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                     {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return box;
}

struct Bench {
    QTemporaryDir folder;
    Session session;
    PartPanel panel{session};

    Bench() {
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder.path());
        panel.show();
    }
    bool open() {
        const QString name = folder.filePath(QStringLiteral("p.nc"));
        QFile file(name);
        const bool written = file.open(QIODevice::WriteOnly) && file.write(kProgram) == kProgram.size();
        file.close();
        if (!written || !opened(session, name))
            return false;
        Setup setup = session.job().setup();
        setup.stock = {{0, 0, 0}, 30, 20, 10};
        setup.spacing = 0.5;
        setup.automaticGrid = false;
        setup.tools.set(1, parseCutter("flat:d=4,l=20").value());
        return session.job().setSetup(setup).has_value();
    }
    /// The part is the uncut stock.
    QString writePart() {
        const QString file = folder.filePath(QStringLiteral("part.stl"));
        const bool written =
            writeStl(toPath(file), boxMesh({0, 0, -10}, {30, 20, 0}), StlEncoding::binary).has_value();
        return written ? file : QString();
    }
    bool compared() {
        return QTest::qWaitFor(
            [this] { return session.check().report() && session.check().report()->part != nullptr; },
            kPatience);
    }
    [[nodiscard]] QTreeView& list() const { return *panel.findChild<QTreeView*>(); }
    [[nodiscard]] QString text(const char* name) const {
        return panel.findChild<QLabel*>(QLatin1String(name))->text();
    }
    [[nodiscard]] QString cell(int row, int column) const {
        return list().model()->index(row, column).data().toString();
    }
};

} // namespace

class PartPanelTest final : public QObject {
    Q_OBJECT

private slots:
    void listsTheIslandsAndGoesToTheirBlocks();
    void aTypedToleranceIsOneStepThatCanBeUndone();
    void saysWhyNothingIsCompared();
    void comparesTheMomentAtRestWhenAskedTo();
    void hasOneLineEach();
};

void PartPanelTest::listsTheIslandsAndGoesToTheirBlocks() {
    Bench bench;
    QVERIFY(!bench.panel.findChild<QToolButton*>(QStringLiteral("part-choose"))->isEnabled());
    QVERIFY(bench.open());
    QVERIFY(!bench.list().isVisible());
    QVERIFY(bench.text("part-empty").startsWith(QStringLiteral("Choose the part")));
    bench.panel.findChild<PartForm*>()->setFile(bench.writePart());
    QVERIFY(bench.compared());
    QVERIFY(bench.list().isVisible());
    QCOMPARE(bench.list().model()->rowCount(), 2);
    QCOMPARE(bench.cell(0, IslandsModel::kKind), QStringLiteral("Gouge"));
    QCOMPARE(bench.cell(0, IslandsModel::kLine), QStringLiteral("9"));
    QCOMPARE(bench.cell(1, IslandsModel::kLine), QStringLiteral("6"));
    QCOMPARE(bench.cell(0, IslandsModel::kTool), QStringLiteral("T1"));
    QVERIFY(bench.text("part-result").startsWith(QStringLiteral("Gouges: 2")));

    QSignalSpy lines(&bench.session.navigation(), &NavigationHub::lineRequested);
    QSignalSpy places(&bench.session.navigation(), &NavigationHub::placeRequested);
    emit bench.list().activated(bench.list().model()->index(1, 0));
    QCOMPARE(lines.count(), 1);
    QCOMPARE(lines[0][0].toUInt(), 6U);
    QCOMPARE(places.count(), 1);
    QVERIFY(QTest::qWaitFor(
        [&] {
            const FramePtr& frame = bench.session.simulation().frame();
            return frame && frame->program->blockLine(frame->block - 1) == 6;
        },
        kPatience));
    QCOMPARE(bench.list().model()->rowCount(), 2);
}

void PartPanelTest::aTypedToleranceIsOneStepThatCanBeUndone() {
    Bench bench;
    QVERIFY(bench.open());
    bench.panel.findChild<PartForm*>()->setFile(bench.writePart());
    QVERIFY(bench.compared());
    auto* below = bench.panel.findChild<NumberBox*>(QStringLiteral("part-below"));
    QVERIFY(below->isEnabled());
    below->setValue(3.5);
    bench.session.job().collectChanges();
    QCOMPARE(bench.session.job().part()->tolerance.below, 3.5);
    QVERIFY(bench.compared());
    bench.session.job().undoStep();
    QCOMPARE(bench.session.job().part()->tolerance.below, 0.1);
    bench.session.job().undoStep();
    QVERIFY(!bench.session.job().part().has_value());
    QVERIFY(!below->isEnabled());
    bench.session.job().redoStep();
    QVERIFY(bench.session.job().part().has_value());
    QVERIFY(bench.compared());
    QCOMPARE(bench.list().model()->rowCount(), 2);
}

void PartPanelTest::saysWhyNothingIsCompared() {
    Bench bench;
    QVERIFY(bench.open());
    QFile bad(bench.folder.filePath(QStringLiteral("bad.stl")));
    QVERIFY(bad.open(QIODevice::WriteOnly) && bad.write("solid x\n") > 0);
    bad.close();
    bench.panel.findChild<PartForm*>()->setFile(bad.fileName());
    QVERIFY(QTest::qWaitFor(
        [&] { return bench.text("part-empty").contains(QStringLiteral("cannot be used")); }, kPatience));
    QVERIFY(!bench.list().isVisible());
    QVERIFY(!bench.panel.findChild<DeviationChart*>()->isVisible());
}

void PartPanelTest::comparesTheMomentAtRestWhenAskedTo() {
    Bench bench;
    QVERIFY(bench.open());
    bench.session.job().setPart(PartSpec{.file = toPath(bench.writePart())});
    QVERIFY(bench.compared());
    QCOMPARE(bench.session.part().comparison(), nullptr);
    bench.session.part().setOn(bench.panel, true);
    QVERIFY(QTest::qWaitFor([&] { return bench.session.part().comparison() != nullptr; }, kPatience));
    QCOMPARE(bench.session.part().comparison()->gouges, 0U);
    bench.session.playback().seek(bench.session.program().current()->blockCount());
    QVERIFY(QTest::qWaitFor(
        [&] {
            const auto& comparison = bench.session.part().comparison();
            return comparison && comparison->gouges == 2;
        },
        kPatience));
    bench.session.part().setOn(bench.panel, false);
    QCOMPARE(bench.session.part().comparison(), nullptr);
}

void PartPanelTest::hasOneLineEach() {
    PartComparison comparison;
    ComparedIsland island;
    island.of = {
        .depthMm = 0.5, .areaMm2 = 2, .volumeMm3 = 1, .place = {1, 2, -3.25}, .lo = {0, 1}, .hi = {2, 3}};
    comparison.islands.push_back(island);
    island.block = 4;
    island.line = 7;
    island.tool = 2;
    comparison.islands.push_back(island);
    QCOMPARE(islandsCsv(comparison),
             "kind,depthMm,areaMm2,volumeMm3,x,y,z,minX,minY,maxX,maxY,block,line,tool\n"
             "gouge,0.5,2,1,1,2,-3.25,0,1,2,3,,,\n"
             "gouge,0.5,2,1,1,2,-3.25,0,1,2,3,5,7,2\n");
}

} // namespace proveout

QTEST_MAIN(proveout::PartPanelTest)
#include "part_panel_test.moc"
