// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <vector>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "core/base/atomic_file.h"
#include "core/decimation/surface/map_memory.h"
#include "core/formats/stock_file.h"
#include "core/zmap/extruded_stock.h"
#include "core/zmap/zmap.h"
#include "tests/core/file_size_limit.h"
#include "tests/core/formats/steep_maps.h"
#include "ui/document/file_paths.h"
#include "ui/look/diagnostic_text.h"
#include "ui/program/export_job.h"

namespace proveout {
namespace {

Frame uncutFrame(double spacing = 0.5) {
    StockBox stock;
    stock.width = 20;
    stock.depth = 10;
    stock.height = 5;
    Frame frame;
    frame.zmap = ZMap(stock, makeGrid(stock, spacing).value()).snapshot();
    return frame;
}

} // namespace

class ExportJobTest : public QObject {
    Q_OBJECT

private slots:
    void memoryIsAskedForBeforeItIsTaken() {
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("part.stl"));
        const Frame frame = uncutFrame();
        ExportOptions full;
        full.decimated = false;
        const Result<ExportSummary> refused = exportFrame(frame, file, full, {}, 20'000);
        QVERIFY(!refused);
        QCOMPARE(refused.error().front().id, "export-needs-too-much-memory");
        DecimationParameters none = frame.parameters;
        none.method = DecimationMethod::none;
        constexpr MapOutputs kOutputs{.schedule = false, .whole = true, .solid = true, .walls = true};
        constexpr double kPoints = 41 * 21;
        const double needed = kPoints * certainBytesPerPoint(none, kOutputs);
        QVERIFY2(sentence(refused.error().front()).contains(QString::fromStdString(readableBytes(needed))),
                 qPrintable(sentence(refused.error().front())));
        QVERIFY(sentence(refused.error().front()).contains(QLatin1String("20 kB")));
        QVERIFY(!hint(refused.error().front()).isEmpty());
        QVERIFY(!QFile::exists(file));
        QVERIFY(exportFrame(frame, file, full, {}, kPoints * meshBytesPerPoint(none, kOutputs)));
        QVERIFY(exportFrame(frame, file, {}, {}, kPoints * meshBytesPerPoint(frame.parameters, kOutputs)));
    }

    void theTrianglesOfADecimatedSurfaceAreWatchedInsteadOfRequired() {
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("part.stl"));
        const Frame frame = uncutFrame(0.01); // 2 million points; 330 MB if no triangle could be removed
        const Result<ExportSummary> refused = exportFrame(frame, file, {}, {}, 1e6);
        QVERIFY(!refused);
        QCOMPARE(refused.error().front().id, "export-needs-too-much-memory");
        QVERIFY(sentence(refused.error().front()).contains(QLatin1String("1.0 MB")));
        QVERIFY(!QFile::exists(file));
        const Result<ExportSummary> written = exportFrame(frame, file, {}, {}, 150e6);
        QVERIFY2(written, written ? "" : qPrintable(sentence(written.error().front())));
        QVERIFY(QFile::exists(file));
    }

    /// Playback shows the moment without its rims.
    void aSavedStockHasTheRimsOfItsMoment() {
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("part.pvstock"));
        auto setup = std::make_shared<Setup>();
        setup->shape.kind = StockKind::cylinder;
        setup->shape.body = extrudedStock({circleOutline(9.7)}, 5).value();
        setup->stock = setup->shape.body->box();
        setup->spacing = 0.5;
        Frame frame;
        frame.setup = setup;
        frame.program = std::make_shared<const Program>();
        frame.zmap =
            uncutStock(setup->stock, setup->shape, makeGrid(setup->stock, 0.5).value()).zmap.snapshot();
        const auto rimsInFile = [&] {
            const auto summary = exportFrame(frame, file, {.format = findFormat("stock")}, {});
            return summary ? countOf(readStock(toPath(file))->zmap.rims()) : 0;
        };
        QVERIFY(rimsInFile() > 50);
        frame.parameters.method = DecimationMethod::lee; // which needs a plain map
        QCOMPARE(rimsInFile(), std::size_t{0});
    }

    void theEndingNamesTheFormatWhereNoneIsChosen() {
        QTemporaryDir folder;
        const Frame frame = uncutFrame();
        const QString obj = folder.filePath(QStringLiteral("part.OBJ"));
        QVERIFY(exportFrame(frame, obj, {}, {}));
        QVERIFY(readFile(toPath(obj))->starts_with("# Proveout"));
        const QString other = folder.filePath(QStringLiteral("part.txt"));
        const Result<ExportSummary> unknown = exportFrame(frame, other, {}, {});
        QVERIFY(!unknown);
        QCOMPARE(unknown.error().front().id, "export-format-unknown");
        QVERIFY(exportFrame(frame, other, {true, findFormat("ply")}, {}));
        QVERIFY(readFile(toPath(other))->starts_with("ply\n"));
    }

    void whatCannotBeWrittenIsRefusedBeforeTheWork() {
        QTemporaryDir folder;
        const Frame frame = uncutFrame();
        const auto refused = [&](const QString& file, bool decimated) {
            int progress = 0;
            ExportOptions options;
            options.decimated = decimated;
            const auto result =
                exportFrame(frame, folder.filePath(file), options, {{}, [&](double) { ++progress; }});
            return !result && progress == 0 ? QString::fromLatin1(result.error().front().id) : QString();
        };
        QVERIFY(QDir(folder.path()).mkdir(QStringLiteral("folder.stl")));
        for (const bool decimated : {true, false}) {
            QCOMPARE(refused(QStringLiteral("none/part.stl"), decimated), QStringLiteral("file-unwritable"));
            QCOMPARE(refused(QStringLiteral("folder.stl"), decimated), QStringLiteral("file-unwritable"));
            QCOMPARE(refused(QStringLiteral("part.stl"), decimated), QString());
        }
        // 40 × 20 cells of two triangles at 50 bytes each.
        const FileSizeLimit limit(79'999);
        QCOMPARE(refused(QStringLiteral("part.stl"), false), QStringLiteral("file-unwritable"));
    }

    void whatAnotherProgramHasWrittenMeanwhileStays() {
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("part.stl"));
        const auto writeTheirs = [&](double) { static_cast<void>(writeFile(toPath(file), "theirs")); };
        const auto result = exportFrame(uncutFrame(), file, {}, {{}, writeTheirs});
        QVERIFY(!result);
        QCOMPARE(result.error().front().id, "file-changed-on-disk");
        QCOMPARE(readFile(toPath(file)).value(), std::string("theirs"));
    }

    /// The mesh is made more than once: steep walls, and steps of float32 of 6e-5 mm.
    void anStlKeepsTheAllowanceWithProgressThatRises() {
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("part.stl"));
        Frame frame;
        frame.zmap = test::waveAt(700.3);
        std::vector<double> reported;
        const auto done =
            exportFrame(frame, file, {}, {{}, [&](double share) { reported.push_back(share); }});
        QVERIFY(done);
        QVERIFY(done->warnings.empty());
        QVERIFY2(done->largestErrorMm <= 0.05, qPrintable(QString::number(done->largestErrorMm)));
        QVERIFY(test::distanceFrom(frame.zmap, *readStl(toPath(file))) <= 0.05 + 1e-9);
        QVERIFY(std::ranges::is_sorted(reported));
        QCOMPARE(reported.back(), 1.0);
        // The first try ends at nine tenths of the part of making.
        constexpr double kSecondTry = 0.9 * 0.88;
        QVERIFY2(
            std::ranges::any_of(reported, [](double share) { return share > kSecondTry && share < 0.88; }),
            "made only once");
        QVERIFY(QFile::remove(file));
        std::stop_source stop;
        const auto cancelled = exportFrame(frame, file, {}, {stop.get_token(), [&](double share) {
                                                                 if (share > kSecondTry)
                                                                     stop.request_stop();
                                                             }});
        QVERIFY(!cancelled);
        QCOMPARE(cancelled.error().front().id, "cancelled");
        QVERIFY(!QFile::exists(file));
    }

    void anStlThatCannotKeepTheAllowanceIsRefused() {
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("part.stl"));
        for (const double far : {80'000.3, 2e6}) { // too far for these walls, and for any
            Frame frame;
            frame.zmap = test::waveAt(far);
            int progress = 0;
            const auto refused = exportFrame(frame, file, {}, {{}, [&](double) { ++progress; }});
            QVERIFY(!refused);
            QCOMPARE(refused.error().front().id, "export-rounding-too-large");
            QVERIFY(sentence(refused.error().front()).startsWith(QLatin1String("part.stl: ")));
            QCOMPARE(progress > 0, far < 1e6);
            QVERIFY(!QFile::exists(file));
            QVERIFY(exportFrame(frame, folder.filePath(QStringLiteral("part.3mf")), {}, {}));
        }
    }

    void whatFailsNamesTheFile() {
        QTemporaryDir folder;
        const Frame frame = uncutFrame();
        ExportOptions full;
        full.decimated = false;
        const auto reportedFor = [&](const QString& file, const WorkContext& context, double memory) {
            const Result<ExportSummary> result = exportFrame(frame, file, full, context, memory);
            return result ? QString() : sentence(result.error().front());
        };
        std::stop_source stopped;
        stopped.request_stop();
        for (const QString& text :
             {reportedFor(folder.filePath(QStringLiteral("bracket.stl")), {}, 0),
              reportedFor(folder.filePath(QStringLiteral("gone/bracket.stl")), {}, 1e9),
              reportedFor(folder.filePath(QStringLiteral("bracket.stl")), {stopped.get_token(), {}}, 1e9)})
            QVERIFY2(text.startsWith(QLatin1String("bracket.stl: ")), qPrintable(text));
    }
};

} // namespace proveout

QTEST_MAIN(proveout::ExportJobTest)
#include "export_job_test.moc"
