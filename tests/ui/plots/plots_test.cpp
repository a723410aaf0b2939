// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <utility>

#include <QApplication>
#include <QPaintDevice>
#include <QPaintEngine>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>

#include "core/nc/run/interpreter.h"
#include "core/simulation/records/block_records.h"
#include "core/simulation/records/block_statistic.h"
#include "tests/ui/opened.h"
#include "tests/ui/save_dialog_user.h"
#include "ui/plots/parameter_trace.h"
#include "ui/plots/plot_changes.h"
#include "ui/plots/plot_csv.h"
#include "ui/plots/plot_grid.h"
#include "ui/plots/plot_ticks.h"
#include "ui/plots/plots_panel.h"
#include "ui/plots/row_curve.h"
#include "ui/plots/row_extremes.h"

using namespace proveout;

namespace {

BlockStatistics randomBlock(std::mt19937& random) {
    BlockStatistics row;
    row.facesFull = 500000;
    row.facesShown = static_cast<std::uint32_t>(random() % 500000);
    row.removedMm3 = static_cast<double>(random() % 1000) / 8;
    row.cutSeconds = static_cast<float>(random() % 64) / 1024;
    row.decimationSeconds = static_cast<float>(random() % 64) / 1024;
    return row;
}

FrameStatistics randomFrame(std::mt19937& random, std::uint32_t block) {
    const auto time = [&] { return static_cast<float>(random() % 64) / 1024; };
    return {block - 1, block, time(), time(), time(), time()};
}

const PlotSpec& plot(const char* id) {
    const auto rows = plotCatalogue();
    const auto row =
        std::ranges::find_if(rows, [&](const PlotSpec& spec) { return std::string_view(spec.id) == id; });
    if (row == rows.end())
        qFatal("there is no plot %s", id);
    return *row;
}

void compare(const PlotView& view, const PlotInput& input) {
    QCOMPARE(view.rows(), input.blocks.size());
    for (std::size_t row = 0; row < view.rows(); ++row)
        for (std::size_t series = 0; series < view.spec().series.size(); ++series)
            QCOMPARE(view.value(series, row), view.spec().y(input, row, series));
}

/// Draws nothing, and counts the points to be drawn.
class CountingEngine : public QPaintEngine {
public:
    using QPaintEngine::drawLines;
    using QPaintEngine::drawPolygon;
    CountingEngine() : QPaintEngine(AllFeatures) {}
    bool begin(QPaintDevice*) override { return true; }
    bool end() override { return true; }
    void updateState(const QPaintEngineState&) override {}
    void drawPixmap(const QRectF&, const QPixmap&, const QRectF&) override {}
    void drawTextItem(const QPointF&, const QTextItem&) override {}
    void drawLines(const QLineF*, int count) override { points += 2 * count; }
    void drawPath(const QPainterPath& path) override { points += path.elementCount(); }
    void drawPolygon(const QPointF*, int count, PolygonDrawMode) override { points += count; }
    Type type() const override { return User; }

    int points = 0;
};

class CountingDevice : public QPaintDevice {
public:
    QPaintEngine* paintEngine() const override { return &m_engine; }
    int points() const { return m_engine.points; }

protected:
    int metric(PaintDeviceMetric metric) const override {
        const bool size = metric == PdmWidth || metric == PdmHeight;
        const bool dots = metric == PdmDpiX || metric == PdmDpiY;
        return size ? 1000 : dots ? 96 : QPaintDevice::metric(metric);
    }

private:
    mutable CountingEngine m_engine;
};

void showPlot(PlotsPanel& panel, const char* id) {
    for (QAction* action : panel.actions())
        if (action->objectName() == QStringLiteral("plot-") + QLatin1String(id))
            action->setChecked(true);
}

std::size_t valuesAsked = 0;

/// The plot of triangle counts, which counts each value that is requested.
PlotSpec countingFaces() {
    PlotSpec spec = plot("faces");
    spec.y = [](const PlotInput& input, std::size_t row, std::size_t series) {
        ++valuesAsked;
        return plot("faces").y(input, row, series);
    };
    return spec;
}

} // namespace

class PlotsTest : public QObject {
    Q_OBJECT

private slots:
    void catalogueRowsAreComplete();
    void statisticsWithAPlotAreInTheCatalogue();
    void historyFindsTheFirstRowThatDiffers();
    void historyKeepsFramesUntilTheirBlocksArePlayedAgain();
    void parameterChangesAreMarkedWhereTheyMeet();
    void viewsHoldWhatTheStatisticsSay();
    void stackedCurvesAddUp();
    void csvHoldsEveryValue();
    void ratesAreThoseOfTheMachinesTime();
    void clickSeeksAndDragDoesNot();
    void amongManyRowsTheOneThatIsSeenIsMeant();
    void followingKeepsTheBlockInSight();
    void hoverReadsTheNearestRow();
    void axesWriteLargeCountsShort();
    void fewFacesAreReadBesideMillions();
    void aJumpShowsTheTimeOfEachBlock();
    void plotsWrapIntoRows();
    void restylesWithThePalette();
    void manyRowsCostLittle();
    void rowsInTheMiddleAreReplacedAlone();
    void extremesAreThoseOfAnyStretch();
    void appendedRowsKeepTheExtremesOfEarlierRows();
    void columnsReachTheirLowestAndHighestRow();
    void aDrawingLooksAtPixelsAndNotAtRows();
    void tracesOfManyUpdatesAreThoseOfEachRow();
    void onlyShownPlotsAreFilled();
    void aPlotSwitchedOnInAHiddenPanelIsFilled();
    void fillingsAreUnderTheirCurves();
    void jaggedFillingsCostLittle();
    void panelShowsARunAndExportsIt();
    void exportAsksBeforeItOverwrites();
};

void PlotsTest::catalogueRowsAreComplete() {
    std::set<std::string> ids;
    for (const PlotSpec& spec : plotCatalogue()) {
        QVERIFY(ids.insert(spec.id).second);
        QVERIFY(*spec.title != '\0' && *spec.xLabel != '\0' && *spec.yLabel != '\0');
        std::set<std::pair<int, int>> looks;
        for (const PlotSeries& series : spec.series) // must be distinguishable without colour
            QVERIFY(looks.insert({static_cast<int>(series.pen), static_cast<int>(series.fill)}).second);
    }
    QVERIFY(ids.contains("faces") && ids.contains("block-time"));
}

void PlotsTest::statisticsWithAPlotAreInTheCatalogue() {
    std::mt19937 random(4);
    PersistentArray<BlockStatistics> blocks;
    for (int k = 0; k < 20; ++k) {
        BlockStatistics row = randomBlock(random);
        row.maxDepth = static_cast<float>(random() % 64) / 16;
        row.radialEngagement = static_cast<float>(random() % 64) / 8;
        blocks.push_back(row);
    }
    int plotted = 0;
    for (const BlockStatistic& statistic : blockStatistics()) {
        if (statistic.plot == nullptr)
            continue;
        ++plotted;
        const PlotSpec& spec = plot(statistic.plot->id);
        QCOMPARE(spec.title, statistic.plot->title);
        QCOMPARE(spec.yLabel, statistic.plot->axis);
        QCOMPARE(spec.series.size(), std::size_t{1});
        QCOMPARE(spec.series[0].key, statistic.column);
        for (std::size_t row = 0; row < blocks.size(); ++row)
            QCOMPARE(spec.y({blocks, {}}, row, 0), asNumber(statistic.read({blocks}, row)));
    }
    QVERIFY(plotted > 0);
    for (const PlotSeries& series : plot("faces").series)
        QVERIFY(findStatistic(series.key) != nullptr);
}

void PlotsTest::historyFindsTheFirstRowThatDiffers() {
    std::mt19937 random(5);
    PersistentArray<BlockStatistics> blocks;
    std::vector<FrameStatistics> frames;
    PlotHistory history;
    QVERIFY(!history.update(blocks, frames, true).any);
    for (int k = 0; k < 700; ++k)
        blocks.push_back(randomBlock(random));
    auto changes = history.update(blocks, frames, true);
    QVERIFY(changes.any && changes.blocks.first == 0);
    blocks.push_back(randomBlock(random));
    frames.push_back(randomFrame(random, 701));
    changes = history.update(blocks, frames, true);
    QVERIFY(changes.any && changes.blocks.first == 700 && changes.firstFrame == 0);
    QVERIFY(!history.update(blocks, frames, true).any);
    blocks.edit(300).cutSeconds += 1;
    changes = history.update(blocks, frames, true);
    QVERIFY(changes.any && changes.blocks.first == 300 && changes.firstFrame == 1);
    blocks.truncate(10);
    frames.clear();
    history.forgetFrames();
    changes = history.update(blocks, frames, true);
    QVERIFY(changes.any && changes.blocks.first == 10 && changes.firstFrame == 0);
}

void PlotsTest::historyKeepsFramesUntilTheirBlocksArePlayedAgain() {
    const PersistentArray<BlockStatistics> blocks;
    PlotHistory history;
    const auto lastBlocks = [&] {
        std::vector<std::uint32_t> last;
        for (const FrameStatistics& frame : history.frames())
            last.push_back(frame.lastBlock);
        return last;
    };
    using Blocks = std::vector<std::uint32_t>;
    static_cast<void>(history.update(blocks, {{0, 5}, {5, 10}, {10, 12}, {12, 20}}, true));
    QVERIFY(!history.update(blocks, {}, false).any); // seek to the start
    QCOMPARE(lastBlocks(), (Blocks{5, 10, 12, 20}));
    QVERIFY(!history.update(blocks, {{0, 12}}, false).any); // scrubbing over measured blocks
    const auto played = history.update(blocks, {{0, 12}, {12, 14}}, true);
    QVERIFY(played.any && played.firstFrame == 3);
    QCOMPARE(lastBlocks(), (Blocks{5, 10, 12, 14, 20})); // blocks that were not played again stay
    QCOMPARE(history.update(blocks, {{0, 7}}, true).firstFrame, std::size_t{0});
    QCOMPARE(lastBlocks(), (Blocks{7, 10, 12, 14, 20}));
    QCOMPARE(history.frames()[1].firstBlock, std::uint32_t{7});
    static_cast<void>(history.update(blocks, {{0, 7}, {7, 40}}, false)); // past everything measured before
    QCOMPARE(lastBlocks(), (Blocks{7, 40}));
    history.forgetFrames();
    QVERIFY(history.update(blocks, {}, false).any);
    QVERIFY(lastBlocks().empty());
}

void PlotsTest::parameterChangesAreMarkedWhereTheyMeet() {
    using Blocks = std::vector<std::size_t>;
    DecimationParameters first;
    DecimationParameters second;
    second.allowance *= 2;
    ParameterTrace trace;
    trace.update(first, 0, 100, 100);
    QVERIFY(trace.changes().empty());
    trace.update(second, 100, 100, 100); // changed at rest: no row uses it yet
    QVERIFY(trace.changes().empty());
    trace.update(second, 100, 130, 130);
    QCOMPARE(trace.changes(), Blocks{100});
    trace.update(second, 40, 60, 130); // after a seek back, played again from 40
    QCOMPARE(trace.changes(), (Blocks{40, 60, 100}));
    trace.update(second, 60, 120, 130);
    QCOMPARE(trace.changes(), Blocks{40});
    trace.update(first, 40, 130, 130); // change undone
    QVERIFY(trace.changes().empty());
    trace.update(second, 0, 0, 0); // a load
    trace.update(second, 0, 10, 10);
    QVERIFY(trace.changes().empty());

    PlotView view(plot("faces"));
    view.setParameterChanges({40, 60});
    view.setParameterChanges({40});
    QCOMPARE(view.itemCount(), 3); // including the current block and the hint
}

void PlotsTest::viewsHoldWhatTheStatisticsSay() {
    std::mt19937 random(11);
    PersistentArray<BlockStatistics> blocks;
    std::vector<FrameStatistics> frames;
    std::vector<FrameStatistics> measured; // one per block; a seek back removes none
    PlotHistory history;
    PlotView faces(plot("faces"));
    PlotView times(plot("block-time"));
    for (int round = 0; round < 60; ++round) {
        const std::size_t keep = random() % 4 == 0 ? random() % (blocks.size() + 1) : blocks.size();
        blocks.truncate(keep);
        frames.resize(std::min(frames.size(), keep));
        for (std::size_t k = random() % 20; k > 0; --k) {
            blocks.push_back(randomBlock(random));
            frames.push_back(randomFrame(random, static_cast<std::uint32_t>(frames.size() + 1)));
            measured.resize(std::max(measured.size(), frames.size()));
            measured[frames.size() - 1] = frames.back();
        }
        const auto changes = history.update(blocks, frames, true);
        const PlotInput input{history.blocks(), history.frames()};
        faces.setRows(input, changes.blocks);
        RowRange changed = changes.blocks;
        changed.include(changes.pictured);
        times.setRows(input, changed);
        compare(faces, {blocks, frames});
        compare(times, {blocks, measured});
    }
}

void PlotsTest::stackedCurvesAddUp() {
    PersistentArray<BlockStatistics> blocks;
    blocks.push_back({0, 0, 0, 0, 0.001f, 0.002f, 0, 0, 0});
    const std::vector<FrameStatistics> frames{{0, 1, 0.001f, 0.002f, 0.003f, 0.004f}};
    PlotView times(plot("block-time"));
    times.setRows({blocks, frames}, 0);
    const double tops[] = {1, 3, 6, 10};
    for (int series = 0; series < 4; ++series)
        QVERIFY(std::abs(times.graph(series)->data()->constBegin()->value - tops[series]) < 1e-5);
}

void PlotsTest::csvHoldsEveryValue() {
    PersistentArray<BlockStatistics> blocks;
    blocks.push_back({1200, 39200, 3, 1, 0.0005f, 0.25f, 1, 4, 12.5});
    blocks.push_back({980, 39200, 0, 4, 0.00025f, 0, 0, 0, 0});
    const std::vector<FrameStatistics> frames{{0, 2, 0, 0, 0, 0.0125f}};
    QCOMPARE(plotCsv(plot("faces"), {blocks, frames}),
             std::string("block,facesFull,facesShown\n1,39200,1200\n2,39200,980\n"));
    QCOMPARE(plotCsv(plot("removed-volume"), {blocks, frames}),
             std::string("block,removedMm3\n1,12.5\n2,0\n"));
    QCOMPARE(plotCsv(plot("axial-depth"), {blocks, frames}), std::string("block,maxDepthMm\n1,1\n2,0\n"));
    QCOMPARE(plotCsv(plot("radial-engagement"), {blocks, frames}),
             std::string("block,radialEngagementMm\n1,4\n2,0\n"));
    QCOMPARE(plotCsv(plot("block-time"), {blocks, frames}),
             std::string("block,cutMs,decimationMs,uploadMs,drawMs,pictureFirstBlock,pictureLastBlock\n"
                         "1,0.5,250,0,6.25,1,2\n"
                         "2,0.25,0,0,6.25,1,2\n")); // drawing: the mean per block
    QVERIFY(plotCsv(plot("block-time"), {blocks, {}}).ends_with("2,0.25,0,,,,\n"));
}

void PlotsTest::ratesAreThoseOfTheMachinesTime() {
    // Blocks: a rapid, a slot of 8 × 3 mm at 600 mm/min in three blocks, an air cut, and a block without
    // motion.
    InterpretOptions options;
    options.start = Vec3(0);
    const auto program =
        interpret(NcText("G21 G90\nG0 Z-3\nG1 X10 F600\nX30\nX40\nX60\nX60\nM30\n"), options);
    const auto times = machineTimes(program, {});
    PersistentArray<BlockStatistics> blocks(program->blockCount());
    QCOMPARE(blocks.size(), std::size_t{6});
    constexpr double kSection = 8 * 3;
    for (const auto& [block, length] : {std::pair{1, 10.0}, {2, 20.0}, {3, 10.0}})
        blocks.edit(static_cast<std::size_t>(block)).removedMm3 = kSection * length;
    const std::vector<FrameStatistics> frames;
    PlotView rate(plot("removal-rate"));
    PlotView perLength(plot("volume-per-length"));
    for (PlotView* view : {&rate, &perLength}) {
        view->resize(600, 220);
        view->setRows({blocks, frames}, 0);
        view->setBlock(6, 6);
        view->replot();
        QVERIFY(std::isnan(view->value(0, 2))); // no times yet
        QVERIFY(view->valuesAt(view->xAxis->coordToPixel(3)).contains(u'–'));
        view->setRows({blocks, frames, times.get()}, 0);
        view->setBlock(6, 6);
        view->replot();
        QCOMPARE(view->value(0, 0), 0.0);
        QCOMPARE(view->value(0, 4), 0.0);
        QCOMPARE(view->value(0, 5), 0.0); // nothing removed, in no time
    }
    QVERIFY(std::abs(rate.value(0, 2) - kSection * 600) < 1e-6);
    QVERIFY(rate.value(0, 1) < kSection * 600 && rate.value(0, 1) > kSection * 580); // includes acceleration
    for (const std::size_t row : {1U, 2U, 3U})
        QVERIFY(std::abs(perLength.value(0, row) - kSection) < 1e-9);
    QCOMPARE(plotCsv(perLength.spec(), {blocks, frames, times.get()}),
             std::string("block,removedMm3PerMm\n1,0\n2,24\n3,24\n4,24\n5,0\n6,0\n"));
    QVERIFY(plotCsv(perLength.spec(), {blocks, frames}).starts_with("block,removedMm3PerMm\n1,\n2,\n"));
}

void PlotsTest::clickSeeksAndDragDoesNot() {
    PlotView view(plot("faces"));
    view.resize(600, 220);
    view.setBlock(0, 1000);
    view.replot();
    QSignalSpy clicked(&view, &PlotView::blockClicked);
    const QPoint at(static_cast<int>(view.xAxis->coordToPixel(400)), 100);
    QTest::mouseClick(&view, Qt::LeftButton, {}, at);
    QCOMPARE(clicked.size(), 1);
    QVERIFY(std::abs(static_cast<double>(clicked[0][0].value<std::size_t>()) - 400) < 3);
    QTest::mousePress(&view, Qt::LeftButton, {}, at);
    QTest::mouseMove(&view, at - QPoint(80, 0));
    QTest::mouseRelease(&view, Qt::LeftButton, {}, at - QPoint(80, 0));
    QCOMPARE(clicked.size(), 1);
    QVERIFY(!view.following());
    QVERIFY(view.xAxis->range().lower > 0);
    QTest::mouseDClick(&view, Qt::LeftButton, {}, at);
    QVERIFY(view.following());
    QCOMPARE(view.xAxis->range().lower, 0.0);
}

void PlotsTest::amongManyRowsTheOneThatIsSeenIsMeant() {
    constexpr std::size_t kPeak = 43'210;
    PersistentArray<BlockStatistics> blocks(100'000);
    blocks.edit(kPeak).removedMm3 = 77.5;
    PlotView view(plot("removed-volume"));
    view.resize(600, 220);
    view.setRows({blocks, {}}, 0);
    view.setBlock(0, 200'000); // half of them are not simulated yet
    view.replot();
    QSignalSpy clicked(&view, &PlotView::blockClicked);
    const auto at = [&](double block) {
        return QPoint(static_cast<int>(std::floor(view.xAxis->coordToPixel(block))), 100);
    };
    QTest::mouseClick(&view, Qt::LeftButton, {}, at(kPeak + 1));
    QCOMPARE(clicked[0][0].value<std::size_t>(), kPeak + 1);
    const QString text = view.valuesAt(at(kPeak + 1).x());
    QVERIFY2(text.contains(QLocale().toString(kPeak + 1)) && text.contains(QLocale().toString(77.5)),
             qPrintable(text));
    QTest::mouseClick(&view, Qt::LeftButton, {}, at(150'000)); // no data there
    QVERIFY(std::abs(static_cast<double>(clicked[1][0].value<std::size_t>()) - 150'000) < 500);
}

void PlotsTest::followingKeepsTheBlockInSight() {
    PlotView view(plot("faces"));
    view.resize(600, 220);
    view.setBlock(0, 10000);
    view.replot();
    const QPointF at(300, 100);
    const double under = view.xAxis->pixelToCoord(at.x());
    QWheelEvent event(at, at, {}, {0, 960}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&view, &event);
    QVERIFY(std::abs(view.xAxis->coordToPixel(under) - at.x()) < 1);
    view.setFollowing(true);
    for (const std::size_t block : {std::size_t{50}, std::size_t{6000}, std::size_t{10000}}) {
        view.setBlock(block, 10000);
        QVERIFY(view.xAxis->range().contains(static_cast<double>(block)));
    }
}

void PlotsTest::hoverReadsTheNearestRow() {
    PersistentArray<BlockStatistics> blocks;
    for (std::uint32_t k = 1; k <= 100; ++k)
        blocks.push_back({k, 200, 0, 0, 0, 0, 0, 0});
    PlotView view(plot("faces"));
    view.resize(600, 220);
    QVERIFY(view.valuesAt(300).isEmpty());
    QVERIFY(!view.yAxis->tickLabels()); // the labels would be meaningless
    view.setRows({blocks, {}}, 0);
    view.setBlock(100, 100);
    view.replot();
    const QString text = view.valuesAt(view.xAxis->coordToPixel(42.3));
    QVERIFY2(text.contains(QStringLiteral("42")) && text.contains(QStringLiteral("200")), qPrintable(text));
}

void PlotsTest::axesWriteLargeCountsShort() {
    const QString space(QChar(0x202F));
    const QLocale german(QLocale::German);
    QCOMPARE(shortNumber(1'200'000, QLocale::c()), QStringLiteral("1.2") + space + u'M');
    QCOMPARE(shortNumber(1'200'000, german), QStringLiteral("1,2") + space + u'M');
    QCOMPARE(shortNumber(40'000, german), QStringLiteral("40") + space + u'k');
    QCOMPARE(shortNumber(0.002, german), QStringLiteral("0,002"));
    QCOMPARE(shortNumber(2500, QLocale(QLocale::English)), QStringLiteral("2,500"));
    PersistentArray<BlockStatistics> blocks;
    for (std::uint32_t k = 1; k <= 10; ++k)
        blocks.push_back({20'000'000 + k * 1'000'000, 30'000'000, 0, 0, 0, 0, 0, 0});
    PlotView view(plot("faces"));
    view.resize(600, 220);
    view.setRows({blocks, {}}, 0);
    view.setBlock(10, 10);
    view.replot();
    const QVector<QString> labels = view.yAxis->tickVectorLabels();
    QVERIFY2(labels.contains(QStringLiteral("20") + space + u'M'), qPrintable(labels.toList().join(u' ')));
}

void PlotsTest::fewFacesAreReadBesideMillions() {
    // The sawtooth of a decimated surface, with 2 % of the triangles without decimation.
    PersistentArray<BlockStatistics> blocks;
    for (std::uint32_t k = 0; k < 400; ++k)
        blocks.push_back({40'000 + 900 * (k % 20), 2'400'000, 0, 0, 0, 0, 0, 0});
    for (const QSize size : {QSize(320, 150), QSize(640, 300)}) {
        PlotView view(plot("faces"));
        view.resize(size);
        view.setRows({blocks, {}}, 0);
        view.setBlock(400, 400);
        view.replot();
        const QRect area = view.axisRect()->rect();
        const auto heightOf = [&](double faces) { return area.bottom() - view.yAxis->coordToPixel(faces); };
        QVERIFY2(heightOf(40'000) > 4, qPrintable(QString::number(heightOf(40'000)))); // not on the axis
        const double sawtooth = heightOf(57'100) - heightOf(40'000);
        QVERIFY2(sawtooth > 0.05 * area.height(), qPrintable(QString::number(sawtooth)));
        QVERIFY(area.contains(area.center().x(), static_cast<int>(view.yAxis->coordToPixel(2'400'000))));
        QVERIFY(view.yAxis->label() != plot("faces").yLabel); // the label mentions the logarithmic axis
        const QVector<QString> labels = view.yAxis->tickVectorLabels();
        QVERIFY2(labels.size() >= 2 && labels.size() <= 7, qPrintable(labels.toList().join(u' ')));
        QVERIFY2(labels.back().endsWith(u'M'), qPrintable(labels.toList().join(u' ')));
    }
    // Values that differ little use a linear axis from 0.
    for (std::size_t k = 0; k < blocks.size(); ++k)
        blocks.edit(k).facesFull = 120'000;
    PlotView view(plot("faces"));
    view.resize(640, 300);
    view.setRows({blocks, {}}, 0);
    view.setBlock(400, 400);
    QCOMPARE(view.yAxis->range().lower, 0.0);
    QCOMPARE(view.yAxis->label(), QString::fromUtf8(plot("faces").yLabel));
}

void PlotsTest::aJumpShowsTheTimeOfEachBlock() {
    // Ten blocks drawn one by one, then 990 in one frame. Each was cut and every fifth decimated
    // individually.
    constexpr std::uint32_t kLast = 1000;
    PersistentArray<BlockStatistics> blocks(kLast);
    for (std::size_t k = 0; k < kLast; ++k) {
        blocks.edit(k).cutSeconds = k == 600 ? 0.004f : 0.0005f;
        blocks.edit(k).decimationSeconds = k % 5 == 4 ? 0.002f : 0;
    }
    std::vector<FrameStatistics> frames;
    for (std::uint32_t k = 0; k < 10; ++k)
        frames.push_back({k, k + 1, 0.0005f, 0.0005f, 0.0005f, 0.0005f});
    frames.push_back({10, kLast, 0.5f, 0.4f, 990 * 0.0001f, 990 * 0.0002f});
    PlotView times(plot("block-time"));
    times.resize(600, 220);
    times.setRows({blocks, frames}, 0);
    times.setBlock(kLast, kLast);
    times.replot();
    const auto is = [&](std::size_t series, std::size_t row, double expected) {
        QVERIFY2(std::abs(times.value(series, row) - expected) < 1e-4,
                 qPrintable(QString::number(times.value(series, row))));
    };
    is(0, 600, 4); // hidden in the mean of the frame
    is(0, 601, 0.5);
    is(1, 604, 2);
    is(1, 605, 0);
    is(2, 604, 0.1);
    is(3, 604, 0.2);
    is(3, 4, 0.5);
    // A mean is shown as such, with its blocks.
    times.setFollowing(false);
    times.xAxis->setRange(595, 605);
    times.setBlock(kLast, kLast);
    const QString jump = times.valuesAt(times.xAxis->coordToPixel(601));
    QVERIFY2(jump.startsWith(QStringLiteral("Block 601\n")), qPrintable(jump));
    QVERIFY2(jump.contains(QStringLiteral("11 to %1").arg(QLocale().toString(kLast))), qPrintable(jump));
    times.xAxis->setRange(0, 10);
    times.setBlock(kLast, kLast);
    QVERIFY(!times.valuesAt(times.xAxis->coordToPixel(5)).contains(QStringLiteral(" to ")));
    // Blocks that are in no frame yet have no drawing time, which is not the same as 0.
    times.setRows({blocks, {}}, 0);
    QVERIFY(std::isnan(times.value(3, 20)));
    is(0, 20, 0.5);
}

void PlotsTest::plotsWrapIntoRows() {
    Session session;
    PlotsPanel panel(session);
    panel.show();
    for (PlotView* view : panel.views()) // shows all of them
        if (view->isHidden())
            panel.findChild<QAction*>(QStringLiteral("plot-") + view->objectName())->trigger();
    struct Case {
        QSize size;
        bool scrolls;
    };
    for (const auto& [size, scrolls] : {Case{{1280, 230}, true}, Case{{640, 300}, true},
                                        Case{{2560, 420}, false}, Case{{1280, 700}, false}}) {
        panel.resize(size);
        QTRY_COMPARE(panel.size(), size);
        auto* grid = panel.findChild<PlotGrid*>();
        QTRY_COMPARE(grid->verticalScrollBar()->isVisible(), scrolls);
        QRegion taken;
        for (const PlotView* view : panel.views()) {
            QVERIFY(view->width() >= PlotGrid::kLeastWidth && view->height() >= PlotGrid::kLeastHeight);
            QVERIFY(!taken.intersects(view->geometry()));
            taken += view->geometry();
            QVERIFY(view->axisRect()->width() > view->width() / 2);
        }
        QCOMPARE(taken.boundingRect().width(), grid->viewport()->width());
    }
    // The wheel scrolls, and zooms with Ctrl.
    panel.resize(640, 300);
    auto* bar = panel.findChild<PlotGrid*>()->verticalScrollBar();
    QTRY_VERIFY(bar->maximum() > 0);
    PlotView& first = *panel.views().front();
    first.setBlock(0, 1000);
    const auto wheel = [&](Qt::KeyboardModifiers modifiers, int angle) {
        const QPointF at(150, 80);
        QWheelEvent event(at, first.mapToGlobal(at), {}, {0, angle}, Qt::NoButton, modifiers,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(&first, &event);
    };
    wheel({}, -120);
    QVERIFY(bar->value() > 0);
    QCOMPARE(first.xAxis->range().size(), 1000.0);
    wheel(Qt::ControlModifier, 120);
    QVERIFY(first.xAxis->range().size() < 1000);
    // A hidden plot leaves no gap.
    panel.resize(1280, 700);
    for (PlotView* view : panel.views())
        if (view != &first)
            panel.findChild<QAction*>(QStringLiteral("plot-") + view->objectName())->trigger();
    QTRY_COMPARE(first.width(), panel.findChild<PlotGrid*>()->viewport()->width());
}

void PlotsTest::restylesWithThePalette() {
    PlotView view(plot("faces"));
    view.resize(300, 150);
    QPalette palette;
    for (const QColor& ground : {QColor(Qt::black), QColor(Qt::white)}) {
        const QColor ink = ground == QColor(Qt::black) ? Qt::white : Qt::black;
        palette.setColor(QPalette::Window, ground);
        palette.setColor(QPalette::WindowText, ink);
        palette.setColor(QPalette::Base, ground);
        palette.setColor(QPalette::Text, ink);
        view.setPalette(palette);
        view.replot();
        QCOMPARE(view.toPixmap().toImage().pixelColor(1, 1), ground);
        QCOMPARE(view.xAxis->tickLabelColor(), ink);
    }
}

void PlotsTest::manyRowsCostLittle() {
    std::mt19937 random(3);
    PersistentArray<BlockStatistics> blocks;
    const std::vector<FrameStatistics> frames;
    // The paper's sawtooth: the number of triangles grows for a period of 20 blocks, then falls.
    const auto addBlock = [&] {
        BlockStatistics row = randomBlock(random);
        row.facesShown = static_cast<std::uint32_t>(40000 + 900 * (blocks.size() % 20) + random() % 500);
        blocks.push_back(row);
    };
    for (int k = 0; k < 100000; ++k)
        addBlock();
    PlotHistory history;
    const PlotSpec spec = countingFaces();
    PlotView view(spec);
    view.resize(700, 300);
    view.setRows({blocks, frames}, history.update(blocks, frames, true).blocks);
    valuesAsked = 0;
    for (int k = 0; k < 10; ++k)
        addBlock();
    view.setRows({blocks, frames}, history.update(blocks, frames, true).blocks);
    QCOMPARE(valuesAsked, 10 * spec.series.size());
    view.setBlock(blocks.size(), blocks.size());
    // A curve needs the first, last, lowest and highest value of each pixel column.
    CountingDevice device;
    QCPPainter painter;
    painter.begin(&device);
    view.toPainter(&painter, view.width(), view.height());
    painter.end();
    QVERIFY(device.points() > view.width()); // ensures that points were counted
    QVERIFY2(device.points() < 4 * view.width() * view.graphCount(),
             qPrintable(QString::number(device.points())));
}

/// Played again, blocks get other times; the blocks after them stay.
void PlotsTest::rowsInTheMiddleAreReplacedAlone() {
    std::mt19937 random(3);
    PersistentArray<BlockStatistics> blocks;
    const std::vector<FrameStatistics> frames;
    for (int k = 0; k < 100'000; ++k)
        blocks.push_back(randomBlock(random));
    PlotHistory history;
    const PlotSpec spec = countingFaces();
    PlotView view(spec);
    view.setRows({blocks, frames}, history.update(blocks, frames, true).blocks);
    valuesAsked = 0;
    for (std::size_t k = 500; k < 510; ++k)
        blocks.edit(k).facesShown = 7;
    view.setRows({blocks, frames}, history.update(blocks, frames, true).blocks);
    QCOMPARE(valuesAsked, 10 * spec.series.size());
    compare(view, {blocks, frames});
    // The scale of the values follows too.
    view.setFollowing(false);
    view.xAxis->setRange(501, 510);
    view.setBlock(510, blocks.size());
    QVERIFY(view.yAxis->range().lower < 7);
}

/// Values among which some are unknown and some not positive.
double anyValue(std::mt19937& random) {
    const auto number = static_cast<int>(random() % 1000) - 300;
    return number % 10 == 0 ? std::numeric_limits<double>::quiet_NaN() : number;
}

Extremes extremesByLooking(const std::vector<QCPGraphData>& rows, std::size_t first, std::size_t end) {
    Extremes found;
    for (std::size_t row = first; row < std::min(end, rows.size()); ++row) {
        const double value = rows[row].value;
        if (std::isnan(value))
            continue;
        found.lowest = std::min(found.lowest, value);
        found.highest = std::max(found.highest, value);
        if (value > 0)
            found.lowestAbove0 = std::min(found.lowestAbove0, value);
    }
    return found;
}

void compareExtremes(const RowExtremes& extremes, const std::vector<QCPGraphData>& rows, std::size_t first,
                     std::size_t end) {
    const Extremes found = extremes.of(rows, first, end);
    const Extremes expected = extremesByLooking(rows, first, end);
    QCOMPARE(found.lowest, expected.lowest);
    QCOMPARE(found.highest, expected.highest);
    QCOMPARE(found.lowestAbove0, expected.lowestAbove0);
}

void PlotsTest::extremesAreThoseOfAnyStretch() {
    std::mt19937 random(9);
    RowExtremes extremes;
    std::vector<QCPGraphData> rows;
    for (int round = 0; round < 3000; ++round) {
        const std::size_t first = random() % (rows.size() + 1);
        if (random() % 5 == 0) {
            rows.resize(first);
            extremes.update(rows, first, first);
        } else {
            const std::size_t end = first + random() % (random() % 50 == 0 ? 6000 : 40);
            rows.resize(std::max(rows.size(), end));
            for (std::size_t row = first; row < end; ++row)
                rows[row] = {static_cast<double>(row + 1), anyValue(random)};
            extremes.update(rows, first, end);
        }
        const std::size_t from = random() % (rows.size() + 1);
        const std::size_t to = from + random() % (rows.size() + 2);
        compareExtremes(extremes, rows, from, to);
    }
}

/// An append that starts exactly at 256, 4096, 65 536 or 1 048 576 rows needs one more level, which must also
/// contain the rows before it.
void PlotsTest::appendedRowsKeepTheExtremesOfEarlierRows() {
    constexpr std::array kFirst{-5000.0, 5000.0, 0.5}; // the extremes of all rows
    std::mt19937 random(13);
    RowExtremes extremes;
    std::vector<QCPGraphData> rows;
    const auto append = [&](std::size_t count) {
        const std::size_t first = rows.size();
        for (std::size_t row = first; row < first + count; ++row)
            rows.emplace_back(static_cast<double>(row + 1),
                              row < kFirst.size() ? kFirst[row] : anyValue(random));
        extremes.update(rows, first, rows.size());
        compareExtremes(extremes, rows, 0, rows.size());
        const std::size_t from = random() % rows.size();
        compareExtremes(extremes, rows, from, from + random() % rows.size());
    };
    const auto truncate = [&](std::size_t count) {
        rows.resize(count);
        extremes.update(rows, count, count);
        compareExtremes(extremes, rows, 0, count);
    };
    while (rows.size() < 5000)
        append(1);
    truncate(256);
    while (rows.size() < 600)
        append(1);
    truncate(0);
    for (int slice = 0; slice < 9; ++slice) // as many rows at once as a filling plot with two curves
        append(131'072);
    truncate(65'536);
    append(100);
}

/// Shows the points that are drawn.
class OpenCurve : public RowCurve {
public:
    using RowCurve::RowCurve;
    [[nodiscard]] QVector<QCPGraphData> points(const QCPRange& keys) const {
        QVector<QCPGraphData> points;
        getOptimizedLineData(&points, data()->findBegin(keys.lower), data()->findEnd(keys.upper));
        return points;
    }
};

void PlotsTest::columnsReachTheirLowestAndHighestRow() {
    std::mt19937 random(10);
    constexpr std::size_t kRows = 50'000;
    QCustomPlot plot;
    plot.resize(500, 200);
    auto* curve = new OpenCurve(plot.xAxis, plot.yAxis);
    std::vector<double> values(kRows);
    std::ranges::generate(values, [&] { return anyValue(random); });
    std::fill(values.begin() + 20'000, values.begin() + 21'000, std::numeric_limits<double>::quiet_NaN());
    curve->setValues(0, values);
    plot.xAxis->setRange(3000, 44'000);
    plot.replot();
    const auto columnOf = [&](double key) {
        return static_cast<int>(std::floor(plot.xAxis->coordToPixel(key)));
    };
    std::map<int, Extremes> expected;
    for (std::size_t row = 2998; row <= 44'000; ++row)
        expected[columnOf(static_cast<double>(row + 1))].add(values[row]);
    std::map<int, Extremes> drawn;
    for (const QCPGraphData& point : curve->points(plot.xAxis->range()))
        drawn[columnOf(point.key)].add(point.value);
    QCOMPARE(drawn.size(), expected.size());
    int gaps = 0;
    for (const auto& [column, extremes] : expected) {
        QVERIFY(drawn.contains(column));
        // At both ends a column may contain rows beyond the range.
        if (column == expected.begin()->first || column == expected.rbegin()->first)
            continue;
        gaps += extremes.empty() ? 1 : 0;
        QCOMPARE(drawn[column].lowest, extremes.lowest);
        QCOMPARE(drawn[column].highest, extremes.highest);
    }
    QVERIFY(gaps > 3); // unknown values stay a gap
}

/// The CPU seconds of one tick while blocks are played again, as the panel does it.
double tickSeconds(std::size_t rows) {
    std::mt19937 random(3);
    PersistentArray<BlockStatistics> blocks;
    for (std::size_t k = 0; k < rows; ++k)
        blocks.push_back(randomBlock(random));
    PlotHistory history;
    PlotView view(plot("faces"));
    view.resize(700, 300);
    view.setRows({blocks, {}}, history.update(blocks, {}, true).blocks);
    view.setBlock(rows / 2, rows);
    view.replot();
    constexpr int kTicks = 20;
    const std::clock_t begin = std::clock();
    for (std::size_t tick = 0; tick < kTicks; ++tick) {
        for (std::size_t k = 0; k < 30; ++k)
            blocks.edit(rows / 2 + 30 * tick + k).facesShown = static_cast<std::uint32_t>(random() % 1000);
        view.setRows({blocks, {}}, history.update(blocks, {}, true).blocks);
        view.setBlock(rows / 2 + 30 * tick, rows);
        view.replot();
    }
    return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC / kTicks;
}

void PlotsTest::aDrawingLooksAtPixelsAndNotAtRows() {
    const double few = std::min(tickSeconds(30'000), tickSeconds(30'000));
    const double many = std::min(tickSeconds(1'000'000), tickSeconds(1'000'000));
    qInfo("a tick: %.2f ms with 30 000 rows, %.2f ms with 1 000 000", 1e3 * few, 1e3 * many);
    QVERIFY2(many < 3 * few, qPrintable(QStringLiteral("%1 %2").arg(many).arg(few)));
}

void PlotsTest::tracesOfManyUpdatesAreThoseOfEachRow() {
    std::mt19937 random(12);
    ParameterTrace trace;
    std::vector<double> used; // the allowance of each row
    for (int round = 0; round < 2000; ++round) {
        DecimationParameters parameters;
        parameters.allowance = 1 + static_cast<double>(random() % 3);
        const std::size_t rows = random() % 20 == 0 ? random() % 100 : used.size() + random() % 10;
        const std::size_t first = random() % (rows + 1);
        const std::size_t executed = first + random() % 30;
        trace.update(parameters, first, executed, rows);
        used.resize(rows, parameters.allowance);
        for (std::size_t row = first; row < std::min(executed, rows); ++row)
            used[row] = parameters.allowance;
        std::vector<std::size_t> changes;
        for (std::size_t row = 1; row < rows; ++row)
            if (used[row] != used[row - 1])
                changes.push_back(row);
        QCOMPARE(trace.changes(), changes);
    }
}

/// A program so long that its plots are filled in several slices.
void PlotsTest::onlyShownPlotsAreFilled() {
    constexpr std::size_t kLines = 100'000;
    QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("long.nc")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("G21 G90 T1 M6\nF1000 S1000 M3\nG0 X0 Y0 Z50\nG1\n");
    for (std::size_t k = 1; k < kLines; ++k)
        file.write(k % 2 == 0 ? "X0\n" : "X1\n");
    file.close();
    Session session;
    PlotsPanel panel(session);
    panel.resize(700, 300);
    panel.show();
    QVERIFY(opened(session, file.fileName()));
    QTRY_VERIFY_WITH_TIMEOUT(session.program().current() && !session.program().isReading(), 30'000);
    const std::size_t blocks = session.program().blockCount();
    QVERIFY(blocks >= kLines);
    session.playback().seek(blocks);
    PlotView& shown = *panel.views().front();
    PlotView& hidden = *panel.views().back();
    QVERIFY(shown.isVisible() && !hidden.isVisible());
    QTRY_COMPARE_WITH_TIMEOUT(shown.rows(), blocks, 30'000);
    QCOMPARE(hidden.rows(), std::size_t{0});
    showPlot(panel, hidden.spec().id);
    QVERIFY(hidden.isVisible());
    QTRY_COMPARE_WITH_TIMEOUT(hidden.rows(), blocks, 30'000);
    const PlotInput input{session.simulation().frame()->statistics,
                          {},
                          session.program().times().get(),
                          session.program().current().get()};
    compare(shown, input);
    for (const PlotView* view : panel.views())
        showPlot(panel, view->spec().id);
    for (const PlotView* view : panel.views())
        QTRY_COMPARE_WITH_TIMEOUT(view->rows(), blocks, 30'000);
}

void PlotsTest::aPlotSwitchedOnInAHiddenPanelIsFilled() {
    Session session;
    PlotsPanel panel(session);
    panel.resize(900, 260);
    panel.show();
    QVERIFY(opened(session, QStringLiteral(PROVEOUT_SOURCE_DIR "/resources/samples/core-insert.proveout")));
    QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame() != nullptr, 10'000);
    session.playback().seek(120);
    QTRY_COMPARE_WITH_TIMEOUT(session.simulation().block(), std::size_t{120}, 10'000);
    QTRY_COMPARE_WITH_TIMEOUT(panel.views().front()->rows(), std::size_t{120}, 10'000);
    QTRY_VERIFY_WITH_TIMEOUT(session.program().times() != nullptr, 10'000);
    QTest::qWait(100); // until the panel has used the times
    panel.hide();
    const auto viewOf = [&](const char* id) {
        return panel.views()[static_cast<std::size_t>(&plot(id) - plotCatalogue().data())];
    };
    PlotView& rate = *viewOf("removal-rate");
    PlotView& volume = *viewOf("removed-volume");
    showPlot(panel, "removal-rate");
    showPlot(panel, "removed-volume");
    QCOMPARE(rate.rows(), std::size_t{0});
    QCOMPARE(volume.rows(), std::size_t{0});
    // An exported picture has all rows, and axes that fit them.
    QVERIFY(!volume.yAxis->tickLabels());
    QTemporaryDir folder;
    QVERIFY(panel.exportTo(volume, folder.filePath(QStringLiteral("volume.svg")), PlotFormat::svg));
    QCOMPARE(volume.rows(), std::size_t{120});
    QVERIFY(volume.yAxis->tickLabels());
    // Nothing has changed since, but the plot is still filled.
    panel.show();
    QVERIFY(rate.isVisible());
    QCOMPARE(rate.rows(), std::size_t{120});
    QVERIFY(rate.yAxis->tickLabels());
}

/// Compares with Qt's polygons for simple shapes.
void PlotsTest::fillingsAreUnderTheirCurves() {
    const auto picture = [](const char* id, bool columns) {
        PersistentArray<BlockStatistics> blocks;
        for (int k = 0; k < 40; ++k) {
            BlockStatistics row;
            row.removedMm3 = k % 7 * 3 + k % 3;
            row.cutSeconds = static_cast<float>(k % 5);
            row.decimationSeconds = 1;
            blocks.push_back(row);
        }
        std::vector<FrameStatistics> frames;
        for (std::uint32_t k = 0; k < 40; ++k)
            frames.push_back({k, k + 1, static_cast<float>(k % 5), 1, static_cast<float>(k % 3), 2});
        PlotView view(plot(id));
        view.resize(700, 300);
        view.setRows({blocks, frames}, 0);
        view.setBlock(30, 50);
        // Only fills, because lines are antialiased differently.
        for (int index = 0; index < view.graphCount(); ++index)
            view.graph(index)->setPen(Qt::NoPen);
        for (int index = 0; index < view.itemCount(); ++index)
            view.item(index)->setVisible(false);
        for (QCPAxis* axis : {view.xAxis, view.yAxis})
            axis->grid()->setVisible(false);
        QImage image(view.size(), QImage::Format_RGB32);
        image.fill(Qt::white);
        QCPPainter painter(&image);
        if (!columns)
            painter.setMode(QCPPainter::pmVectorized);
        view.toPainter(&painter, view.width(), view.height());
        painter.end();
        return image.copy(view.axisRect()->rect().adjusted(10, 10, -10, -10)); // without ticks
    };
    for (const char* id : {"removed-volume", "block-time"}) {
        const QImage columns = picture(id, true);
        const QImage polygons = picture(id, false);
        QCOMPARE(columns.size(), polygons.size());
        int different = 0;
        for (int y = 0; y < columns.height(); ++y)
            for (int x = 0; x < columns.width(); ++x)
                different += std::abs(qGray(columns.pixel(x, y)) - qGray(polygons.pixel(x, y))) > 20 ? 1 : 0;
        // Only pixels at edges may differ, and each column has as many edges as curves.
        const int edges = columns.width() * static_cast<int>(plot(id).series.size());
        QVERIFY2(different < 2 * edges, qPrintable(QString::number(different)));
    }
}

void PlotsTest::jaggedFillingsCostLittle() {
    std::mt19937 random(3);
    PersistentArray<BlockStatistics> blocks;
    for (int k = 0; k < 20'000; ++k)
        blocks.push_back(randomBlock(random));
    const auto seconds = [&](bool filled) {
        PlotView view(plot("removed-volume"));
        view.resize(700, 300);
        view.setRows({blocks, {}}, 0);
        if (!filled)
            view.graph(0)->setBrush(Qt::NoBrush);
        view.setBlock(blocks.size(), blocks.size());
        view.replot(); // updates the layout
        const std::clock_t begin = std::clock();
        for (int k = 0; k < 5; ++k)
            view.replot();
        return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    };
    const double line = seconds(false);
    const double filled = seconds(true);
    QVERIFY2(filled < 8 * line, qPrintable(QStringLiteral("%1 %2").arg(filled).arg(line)));
}

void PlotsTest::panelShowsARunAndExportsIt() {
    Session session;
    PlotsPanel panel(session);
    panel.resize(900, 260);
    panel.show();
    QVERIFY(opened(session, QStringLiteral(PROVEOUT_SOURCE_DIR "/resources/samples/core-insert.proveout")));
    QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame() != nullptr, 10000);
    connect(&session.playback(), &PlaybackHub::tick, this, [&](const FramePtr& drawn) {
        if (drawn)
            session.playback().reportDrawn(drawn->sequence, 0.001, 0.002);
    });
    session.playback().seek(120);
    QTRY_COMPARE_WITH_TIMEOUT(session.simulation().block(), std::size_t{120}, 10000);
    QTRY_COMPARE(panel.views()[1]->rows(), std::size_t{120}); // also after a jump, immediately
    PlotView& faces = *panel.views().front();
    QVERIFY(std::isnan(faces.value(1, 60))); // passed on the way
    QVERIFY(!std::isnan(faces.value(1, 119)));
    QVERIFY(faces.hint().text().contains(QStringLiteral("Ctrl+Shift+M")));
    session.playback().measure();
    QTRY_COMPARE_WITH_TIMEOUT(session.simulation().block(), session.program().blockCount(), 30'000);
    session.playback().seek(120);
    QTRY_COMPARE_WITH_TIMEOUT(session.simulation().block(), std::size_t{120}, 10000);
    QTRY_VERIFY_WITH_TIMEOUT(faces.hint().text().isEmpty(), 10'000);
    const FramePtr frame = session.simulation().frame();
    QCOMPARE(frame->statistics.size(), session.program().blockCount());
    for (std::size_t row = 0; row < 120; ++row) {
        QCOMPARE(faces.value(0, row), static_cast<double>(frame->statistics[row].facesFull));
        QCOMPARE(faces.value(1, row), static_cast<double>(frame->statistics[row].facesShown));
    }
    PlotView& rate = *panel.views()[static_cast<std::size_t>(&plot("removal-rate") - plotCatalogue().data())];
    showPlot(panel, "removal-rate");
    QTRY_VERIFY_WITH_TIMEOUT(rate.rows() >= 120 && !std::isnan(rate.value(0, 119)), 30'000);
    const auto times = session.program().times(); // they may arrive before or after the rows
    QVERIFY(times != nullptr);
    for (std::size_t row = 0; row < 120; ++row)
        QCOMPARE(rate.value(0, row), machineRemovalRate(*times, row, frame->statistics[row]));
    Machine slow;
    slow.largestFeed = 100;
    session.job().setMachine(slow);
    QTRY_VERIFY_WITH_TIMEOUT(session.program().times() != nullptr && session.program().times() != times,
                             10'000);
    const auto slowTimes = session.program().times();
    QTRY_COMPARE_WITH_TIMEOUT(rate.value(0, 119), machineRemovalRate(*slowTimes, 119, frame->statistics[119]),
                              10'000);
    QVERIFY(slowTimes->parts.feed > times->parts.feed);
    QTemporaryDir folder;
    QVERIFY(panel.exportTo(faces, folder.filePath(QStringLiteral("faces.csv")), PlotFormat::csv));
    QFile csv(folder.filePath(QStringLiteral("faces.csv")));
    QVERIFY(csv.open(QIODevice::ReadOnly));
    QCOMPARE(csv.readLine(), QByteArray("block,facesFull,facesShown\n"));
    QCOMPARE(csv.readLine(), QStringLiteral("1,%1,%2\n")
                                 .arg(frame->statistics[0].facesFull)
                                 .arg(frame->statistics[0].facesShown)
                                 .toLatin1());
    QVERIFY(panel.exportTo(faces, folder.filePath(QStringLiteral("faces.png")), PlotFormat::png));
    QVERIFY(QImage(folder.filePath(QStringLiteral("faces.png"))).width() >= faces.width());
    QVERIFY(panel.exportTo(faces, folder.filePath(QStringLiteral("faces.svg")), PlotFormat::svg));
    QFile svg(folder.filePath(QStringLiteral("faces.svg")));
    QVERIFY(svg.open(QIODevice::ReadOnly) && svg.readAll().contains("<svg"));
    // A missing folder is reported as a problem and not in a dialog.
    QVERIFY(!panel.exportTo(faces, folder.filePath(QStringLiteral("missing/faces.csv")), PlotFormat::csv));
    QVERIFY(!session.problems().all().empty());
    const QPoint at(static_cast<int>(std::lround(faces.xAxis->coordToPixel(60))),
                    faces.axisRect()->center().y());
    const double block = std::round(faces.xAxis->pixelToCoord(at.x()));
    QTest::mouseClick(&faces, Qt::LeftButton, {}, at);
    QTRY_COMPARE_WITH_TIMEOUT(session.simulation().block(), static_cast<std::size_t>(block), 10000);
}

void PlotsTest::exportAsksBeforeItOverwrites() {
    QTemporaryDir folder;
    QFile there(folder.filePath(QStringLiteral("faces.csv")));
    QVERIFY(there.open(QIODevice::WriteOnly));
    there.write("mine");
    there.close();
    Session session;
    PlotsPanel panel(session);
    SaveDialogUser user(folder.filePath(QStringLiteral("faces")));
    QVERIFY(!panel.askAndExport(*panel.views().front(), PlotFormat::csv));
    QVERIFY2(user.question().contains(QLatin1String("faces.csv")), qPrintable(user.question()));
    QVERIFY(there.open(QIODevice::ReadOnly));
    QCOMPARE(there.readAll(), QByteArray("mine"));
}

QTEST_MAIN(PlotsTest)
#include "plots_test.moc"
