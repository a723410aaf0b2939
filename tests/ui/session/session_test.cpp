// SPDX-License-Identifier: GPL-3.0-or-later
// The session alone, without a window: what panels can rely on.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>
#include <QTimer>

#include "core/cutter/cutter.h"
#include "core/formats/stl.h"
#include "tests/ui/opened.h"
#include "ui/document/file_paths.h"
#include "ui/look/diagnostic_text.h"
#include "ui/program/program_index.h"
#include "ui/program/program_source.h"
#include "ui/session/playback_commands.h"
#include "ui/session/session.h"

namespace proveout {
namespace {

constexpr int kPatience = 20'000;
const QString kSample = QStringLiteral(PROVEOUT_SOURCE_DIR "/resources/samples/core-insert.proveout");

bool hasProblem(const Session& session, const char* id) {
    return std::any_of(session.problems().all().begin(), session.problems().all().end(),
                       [&](const Diagnostic& problem) { return std::string(problem.id) == id; });
}

QString write(const QTemporaryDir& folder, const QString& name, const QByteArray& bytes) {
    const QString path = folder.filePath(name);
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("cannot write the test's own file");
    return path;
}

QByteArray bytesOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

const QByteArray kSquare =
    "G21 G90 G17 T1 M6\nS1000 M3\nG0 X0 Y0 Z5\nG1 Z-1 F100\nX10\nY10\nX0\nY0\nG0 Z5\nM30\n";

const QByteArray kUncalled = "G21 G90\nG0 X0 Y0 Z5\nG1 Z-1 F100\nX10\nY10\nX0\nY0\nG0 Z5\nM30\n";

QByteArray longProgram(int lines) {
    QByteArray text = "G21 G90 G17 T1 M6\nS1000 M3\nG0 X0 Y0 Z5\nG1 Z-1 F100\n";
    for (int i = 0; i < lines; ++i)
        text += i % 2 == 0 ? "X10\n" : "X0\n";
    return text + "Y300\nM30\n";
}

/// The largest difference in height between two moments on the same grid.
double heightDifference(const ZMapSnapshot& a, const ZMapSnapshot& b) {
    double largest = 0;
    for (int j = 0; j < a.grid().ny; ++j)
        for (int i = 0; i < a.grid().nx; ++i)
            largest = std::max(largest, std::abs(static_cast<double>(a.height(i, j)) - b.height(i, j)));
    return largest;
}

} // namespace

class SessionTest : public QObject {
    Q_OBJECT

private slots:
    void opensTheSampleJob() {
        Session session;
        QVERIFY(opened(session, kSample));
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame() != nullptr, kPatience);
        QCOMPARE(session.program().blockCount(), std::size_t{255});
        QCOMPARE(session.simulation().block(), std::size_t{0});
        QCOMPARE(session.job().setup().stock.width, 140.0);
        QVERIFY(session.job().setup().tools.find(1) != nullptr);
        QVERIFY(!session.document().modified());
    }

    void seeksStepsAndPlaysToTheEnd() {
        Session session;
        QVERIFY(opened(session, kSample));
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame() != nullptr, kPatience);
        session.playback().seek(100);
        QTRY_COMPARE_WITH_TIMEOUT(session.simulation().block(), std::size_t{100}, kPatience);
        for (int i = 0; i < 5; ++i)
            session.playback().step(1); // fast key presses add up
        QTRY_COMPARE_WITH_TIMEOUT(session.simulation().block(), std::size_t{105}, kPatience);
        session.playback().step(-10);
        QTRY_COMPARE_WITH_TIMEOUT(session.simulation().block(), std::size_t{95}, kPatience);
        session.playback().setSpeed(std::numeric_limits<double>::infinity());
        session.playback().play();
        QVERIFY(session.playback().state().playing);
        QTRY_VERIFY_WITH_TIMEOUT(!session.playback().state().playing, kPatience);
        QCOMPARE(session.simulation().block(), session.program().blockCount());
        session.playback().setSpeed(kUnitBlocksPerSecond);
        session.playback().play(); // restarts at the end of the program
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().block() < session.program().blockCount(), kPatience);
    }

    /// The requested block counts, even if it has not been reached, and not the block on the screen.
    void aSeekUnderWayIsNotLost() {
        Session session;
        QVERIFY(opened(session, kSample));
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame() != nullptr, kPatience);
        Setup setup = session.job().setup();
        setup.automaticGrid = false;
        const auto reload = [&] {
            setup.spacing *= 1.5;
            return session.job().setSetup(setup).has_value();
        };
        session.playback().seek(100);
        QVERIFY(reload());
        QVERIFY(reload());
        QTRY_COMPARE_WITH_TIMEOUT(session.simulation().block(), std::size_t{100}, kPatience);
        session.playback().step(std::numeric_limits<std::ptrdiff_t>::max());
        session.playback().step(-5);
        QVERIFY(reload());
        QTRY_COMPARE_WITH_TIMEOUT(session.simulation().block(), session.program().blockCount() - 5,
                                  kPatience);

        session.playback().seek(session.program().blockCount());
        QTRY_COMPARE_WITH_TIMEOUT(session.simulation().block(), session.program().blockCount(), kPatience);
        session.playback().seek(40);
        session.playback().setSpeed(1e-3); // one block in a quarter of an hour
        session.playback().play();
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().block() < session.program().blockCount(), kPatience);
        QCOMPARE(session.simulation().block(), std::size_t{40});
    }

    /// The step is dropped, and must not be mistaken for a pending one.
    void aStepBeforeThereIsASimulationLeavesNothingBehind() {
        Session session;
        session.playback().step(-1);
        QVERIFY(opened(session, kSample));
        session.playback().step(-1);
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame() != nullptr, kPatience);
        session.playback().setSpeed(std::numeric_limits<double>::infinity());
        session.playback().play();
        QTRY_VERIFY_WITH_TIMEOUT(!session.playback().state().playing, kPatience);
        QCOMPARE(session.simulation().block(), session.program().blockCount());
        session.playback().setSpeed(kUnitBlocksPerSecond);
        session.playback().play(); // restarts at the end of the program
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().block() < session.program().blockCount(), kPatience);
    }

    void aSeekThatWasGivenUpIsNotTakenUpAgain() {
        Session session;
        QVERIFY(opened(session, kSample));
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame() != nullptr, kPatience);
        Setup setup = session.job().setup();
        setup.automaticGrid = false;
        setup.spacing = 0.05;
        QVERIFY(session.job().setSetup(setup).has_value());
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame()->setup->spacing == 0.05, kPatience);
        session.playback().seek(session.program().blockCount()); // takes some seconds
        session.playback().pause();
        setup.spacing = 1;
        QVERIFY(session.job().setSetup(setup).has_value());
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame()->setup->spacing == 1, kPatience);
        QTest::qWait(200);
        QVERIFY(session.simulation().block() < session.program().blockCount());
    }

    void toolChangesAreSteppedThroughWithoutWaiting() {
        QTemporaryDir folder;
        Session session;
        QByteArray text = "G21 G90 G17\n";
        for (int tool = 1; tool <= 4; ++tool)
            text += "T" + QByteArray::number(tool) + " M6\nG0 X0 Y0 Z5\nG1 Z-1 F100\nX9\nG0 Z5\n";
        QVERIFY(opened(session, write(folder, "tools.nc", text + "M30\n")));
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame() != nullptr, kPatience);
        for (int presses = 0; presses < 3; ++presses)
            session.playback().stepToToolChange(1);
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame()->block > 0, kPatience);
        QTest::qWait(100);
        const std::size_t there = session.simulation().block();
        session.playback().seek(0);
        QTRY_COMPARE_WITH_TIMEOUT(session.simulation().block(), std::size_t{0}, kPatience);
        for (int presses = 0; presses < 3; ++presses) {
            const std::size_t from = session.simulation().block();
            session.playback().stepToToolChange(1);
            QTRY_VERIFY_WITH_TIMEOUT(session.simulation().block() > from, kPatience);
        }
        QCOMPARE(there, session.simulation().block());
    }

    void paperModeDrawsEveryBlock() {
        Session session;
        QVERIFY(opened(session, kSample));
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame() != nullptr, kPatience);
        connect(&session.playback(), &PlaybackHub::tick, this, [&](const FramePtr& frame) {
            if (frame)
                session.playback().reportDrawn(frame->sequence, 0.001, 0.002);
        });
        session.playback().setSpeed(std::numeric_limits<double>::infinity(), true);
        session.playback().seek(0);
        session.playback().play();
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().block() >= 20, kPatience);
        session.playback().pause();
        const std::vector<FrameStatistics>& rows = session.playback().frameStatistics();
        QVERIFY(rows.size() >= 20);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            QCOMPARE(rows[i].lastBlock, rows[i].firstBlock + 1); // each row is for a single block
            QCOMPARE(rows[i].firstBlock, static_cast<std::uint32_t>(i));
        }
    }

    void paperModeWaitsForALongUploadButNotForAHiddenWindow() {
        constexpr int kHidden = 2000; // ms after which nothing seems to be drawn
        Session session;
        QVERIFY(opened(session, kSample));
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame() != nullptr, kPatience);
        session.playback().setSpeed(std::numeric_limits<double>::infinity(), true);
        session.playback().seek(0);
        session.playback().play();
        QTRY_COMPARE_WITH_TIMEOUT(session.simulation().block(), std::size_t{1}, kPatience);
        const std::uint64_t sequence = session.simulation().frame()->sequence;
        QTimer uploading;
        connect(&uploading, &QTimer::timeout, this, [&] { session.playback().reportUploading(sequence); });
        uploading.start(100);
        QTest::qWait(2 * kHidden);
        QCOMPARE(session.simulation().block(), std::size_t{1});
        uploading.stop();
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().block() > 1, kPatience);
    }

    void holdsBackOnATinyMapWhilePlayingOnly() {
        QTemporaryDir folder;
        Session session;
        QVERIFY(opened(session, write(folder, "square.nc", kSquare)));
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame() != nullptr, kPatience);
        Setup setup = session.job().setup();
        setup.tools.set(1, parseCutter("flat:d=4,l=20").value());
        setup.automaticGrid = false;
        setup.spacing = 1;
        QVERIFY(session.job().setSetup(setup).has_value());
        const DecimationParameters wanted = session.job().parameters();
        std::size_t held = 0;
        std::size_t played = 0;
        connect(&session.playback(), &PlaybackHub::tick, this, [&](const FramePtr& frame) {
            if (!frame)
                return;
            if (frame->playing) {
                ++played;
                held += frame->parameters.method == DecimationMethod::none ? 1U : 0U;
            }
            session.playback().reportDrawn(frame->sequence, 0.0001, 0.001);
        });
        session.playback().setSpeed(std::numeric_limits<double>::infinity(), true);
        session.playback().seek(0);
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame()->surface.facesFull < 2000 &&
                                     session.simulation().block() == 0,
                                 kPatience);
        QVERIFY(session.simulation().frame()->parameters == wanted);
        session.playback().play();
        QVERIFY(session.playback().heldBack() != nullptr);
        QTRY_VERIFY_WITH_TIMEOUT(!session.playback().state().playing, kPatience);
        QVERIFY(played > 0);
        QCOMPARE(held, played);
        QVERIFY(session.job().parameters() == wanted);
        QVERIFY(session.playback().heldBack() == nullptr);
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame()->parameters == wanted, kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame()->surface.dirtyRegions == 0, kPatience);
    }

    void anEditContinuesFromTheFirstChangedBlock() {
        QTemporaryDir folder;
        Session session;
        QVERIFY(opened(session, write(folder, "square.nc", kSquare)));
        Setup setup = session.job().setup();
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame() != nullptr, kPatience);
        setup = session.job().setup();
        setup.tools.set(1, parseCutter("flat:d=4,l=20").value());
        QVERIFY(session.job().setSetup(setup).has_value());
        session.playback().seek(session.program().blockCount());
        QTRY_COMPARE_WITH_TIMEOUT(session.simulation().block(), session.program().blockCount(), kPatience);
        const ZMapSnapshot before = session.simulation().frame()->zmap;
        const auto oldProgram = session.program().current();

        const std::string text = session.document().text().text.toString();
        const std::size_t place = text.find("Z-1");
        session.document().applyEdit(place, 3, "Z-2");
        QTRY_VERIFY_WITH_TIMEOUT(session.program().current() != oldProgram, kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame()->program == session.program().current() &&
                                     session.simulation().block() == session.program().blockCount(),
                                 kPatience);
        QVERIFY(std::abs(heightDifference(before, session.simulation().frame()->zmap) - 1.0) < 1e-5);

        // The same as opening the edited file.
        QByteArray edited = kSquare;
        edited.replace("Z-1", "Z-2");
        Session fresh;
        QVERIFY(opened(fresh, write(folder, "edited.nc", edited)));
        QTRY_VERIFY_WITH_TIMEOUT(fresh.simulation().frame() != nullptr, kPatience);
        QVERIFY(fresh.job().setSetup(session.job().setup()).has_value());
        fresh.playback().seek(fresh.program().blockCount());
        QTRY_COMPARE_WITH_TIMEOUT(fresh.simulation().block(), fresh.program().blockCount(), kPatience);
        QCOMPARE(heightDifference(fresh.simulation().frame()->zmap, session.simulation().frame()->zmap), 0.0);
    }

    void regionsFollowTheMapUnlessTheirSizeIsNamed() {
        QTemporaryDir folder;
        Session session;
        QVERIFY(opened(session, write(folder, "square.nc", kSquare)));
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame() != nullptr, kPatience);
        QCOMPARE(session.job().parameters().regionCells, 16);
        int reported = 0;
        connect(&session.job(), &JobHub::parametersChanged, this, [&reported] { ++reported; });
        Setup setup = session.job().setup();
        setup.stock.width = 40;
        setup.stock.depth = 30;
        const auto useSpacing = [&](double spacing) {
            setup.automaticGrid = false;
            setup.spacing = spacing;
            return session.job().setSetup(setup).has_value();
        };
        QVERIFY(useSpacing(0.0125)); // 3201 × 2401 points
        QCOMPARE(session.job().parameters().regionCells, 32);
        QCOMPARE(reported, 1);
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame() &&
                                     session.simulation().frame()->surface.grid.cells() == 32,
                                 kPatience);
        QVERIFY(useSpacing(0.5));
        QCOMPARE(session.job().parameters().regionCells, 16);
        DecimationParameters named = session.job().parameters();
        named.regionCells = 24;
        session.job().setParameters(named);
        QVERIFY(useSpacing(0.0125));
        QCOMPARE(session.job().parameters().regionCells, 24);
        named.regionCells = 32; // the default again
        session.job().setParameters(named);
        QVERIFY(useSpacing(0.5));
        QCOMPARE(session.job().parameters().regionCells, 16);
    }

    void aChangedAllowanceChangesTheFaces() {
        Session session;
        QVERIFY(opened(session, kSample));
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame() != nullptr, kPatience);
        session.playback().seek(200);
        QTRY_COMPARE_WITH_TIMEOUT(session.simulation().block(), std::size_t{200}, kPatience);
        const std::size_t before = session.simulation().frame()->surface.faces;
        DecimationParameters parameters = session.job().parameters();
        parameters.allowance = 0.5;
        session.job().setParameters(parameters);
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame()->parameters == parameters &&
                                     session.simulation().frame()->surface.faces < before,
                                 kPatience);
        QCOMPARE(session.simulation().block(), std::size_t{200});
        QVERIFY(session.simulation().frame()->surface.largestError() <= 0.5);
        QVERIFY(session.document().modified()); // the parameters are part of the job
    }

    void exportsWhatTheFrameShows() {
        QTemporaryDir folder;
        Session session;
        QVERIFY(opened(session, kSample));
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame() != nullptr, kPatience);
        session.playback().seek(120);
        QTRY_COMPARE_WITH_TIMEOUT(session.simulation().block(), std::size_t{120}, kPatience);
        const QString file = folder.filePath("part.stl");
        QSignalSpy exported(&session.exports(), &ExportHub::exported);
        session.exports().exportMesh(file, {});
        QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 1, kPatience);
        const Result<TriangleMesh> mesh = readStl(toPath(file));
        QVERIFY(mesh.has_value());
        QCOMPARE(std::uint64_t{mesh->triangles.size()}, session.exports().last()->triangles);
        QCOMPARE(static_cast<qint64>(session.exports().last()->bytes), QFileInfo(file).size());
        double volume = 0; // closed and oriented, so the divergence theorem gives the volume of the remaining
                           // stock
        for (const auto& t : mesh->triangles)
            volume +=
                glm::dot(mesh->vertices[t[0]], glm::cross(mesh->vertices[t[1]], mesh->vertices[t[2]])) / 6;
        const double left = session.simulation().frame()->zmap.volume();
        QVERIFY2(std::abs(volume - left) < 0.01 * left, qPrintable(QString("%1 %2").arg(volume).arg(left)));
    }

    void anUnwritablePathIsAMessage() {
        Session session;
        QVERIFY(opened(session, kSample));
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame() != nullptr, kPatience);
        session.exports().exportMesh(QStringLiteral("/nonexistent/folder/part.stl"), {});
        QTRY_VERIFY_WITH_TIMEOUT(hasProblem(session, "file-unwritable") && !session.work().current(),
                                 kPatience);
        QVERIFY(!session.exports().last());
    }

    void savesBytesAsTheyWere() {
        QTemporaryDir folder;
        const QByteArray bytes =
            "\xEF\xBB\xBFG21\r\n(M\xFChle \xE9)\r\nG0 X1\r\n\r\nM30"; // BOM, Latin-1, no final line end
        const QString file = write(folder, "latin.nc", bytes);
        Session session;
        QVERIFY(opened(session, file));
        QVERIFY(!session.document().text().utf8);
        QCOMPARE(session.document().text().lineEnd, LineEnd::crLf);
        session.document().applyEdit(0, 0, "(a)\r\n");
        session.document().setTextModified(true);
        QVERIFY(session.document().save());
        QByteArray expected = bytes;
        expected.insert(3, "(a)\r\n");
        QCOMPARE(bytesOf(file), expected);
        QVERIFY(!session.document().modified());
    }

    void badInputIsReportedAndLeavesTheDocument() {
        QTemporaryDir folder;
        Session session;
        QVERIFY(opened(session, write(folder, "good.nc", kSquare)));
        QVERIFY(!opened(session, folder.filePath("missing.nc")));
        QVERIFY(!session.problems().all().empty());
        QVERIFY(!opened(session, write(folder, "binary.nc", QByteArray(1000, '\0'))));
        QVERIFY(hasProblem(session, "nc-binary"));
        QVERIFY(!opened(session, write(folder, "wide.nc", QByteArray("\xFF\xFEG\0", 4))));
        QVERIFY(hasProblem(session, "nc-encoding"));
        QVERIFY(!opened(session, write(folder, "broken.proveout", "{\"schema\": ")));
        QVERIFY(!session.problems().all().empty());
        QVERIFY(!opened(session, folder.path()));
        QCOMPARE(QFileInfo(toQString(session.document().text().path)).fileName(), QString("good.nc"));
    }

    void aGridThatIsTooLargeIsRefused() {
        Session session;
        QVERIFY(opened(session, kSample));
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame() != nullptr, kPatience);
        Setup setup = session.job().setup();
        setup.automaticGrid = false;
        setup.spacing = 0.0005;
        const Result<void> done = session.job().setSetup(setup);
        QVERIFY(!done.has_value());
        QCOMPARE(session.job().setup().spacing, 1.0);
        setup.stock.width = -1;
        QVERIFY(!session.job().setSetup(setup).has_value());
    }

    void programsWithoutToolsOrMotionsAreReported() {
        QTemporaryDir folder;
        Session session;
        QVERIFY(opened(session, write(folder, "empty.nc", "%\n(nothing)\n%\n")));
        QTRY_VERIFY_WITH_TIMEOUT(hasProblem(session, "no-motion"), kPatience);
        QCOMPARE(session.program().blockCount(), std::size_t{0});
        QVERIFY(opened(session, write(folder, "square.nc", kSquare)));
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame() != nullptr, kPatience);
        session.playback().seek(session.program().blockCount());
        QTRY_VERIFY_WITH_TIMEOUT(!session.simulation().frame()->findings.empty(),
                                 kPatience); // T1 is not defined
    }

    void fault36ChangesOnTheDiskAreNoticedAlsoAfterARename() {
        QTemporaryDir folder;
        const QString file = write(folder, "watched.nc", kSquare);
        Session session;
        QVERIFY(opened(session, file));
        QSignalSpy changed(&session.document(), &DocumentHub::fileChangedOnDisk);
        for (int round = 1; round <= 2; ++round) {
            const QString next = write(folder, "next.nc", kSquare + QByteArray(round, '\n'));
            std::filesystem::rename(toPath(next), toPath(file)); // as editors save
            QTRY_COMPARE_WITH_TIMEOUT(changed.count(), round, kPatience);
        }
        session.document().reload();
        QVERIFY(openingIsOver(session));
        QCOMPARE(QByteArray::fromStdString(session.document().text().text.toString()), kSquare + "\n\n");
        session.document().applyEdit(0, 0, "(mine)\n");
        session.document().setTextModified(true);
        QVERIFY(session.document().save()); // the window's own save is not reported as a change by another
                                            // program
        QTest::qWait(600);
        QCOMPARE(changed.count(), 2);
    }

    void fault36AChangeBetweenReadingAndWatchingIsNoticed() {
        QTemporaryDir folder;
        const QString file = write(folder, "watched.nc", kSquare);
        Session session;
        QSignalSpy changed(&session.document(), &DocumentHub::fileChangedOnDisk);
        const auto changeBehindItsReader = [&](const QByteArray& text) {
            QThread::msleep(300); // the file has been read by now, but the result needs the event loop
            write(folder, "watched.nc", text);
            QVERIFY(openingIsOver(session));
            if (session.document().text().text.toString() == text.toStdString())
                QSKIP("the machine is too busy: the text was not read in time");
        };
        session.document().openFile(file);
        changeBehindItsReader(kSquare + "\n");
        QTRY_COMPARE_WITH_TIMEOUT(changed.count(), 1, kPatience);
        session.document().reload();
        changeBehindItsReader(kSquare + "\n\n");
        QTRY_COMPARE_WITH_TIMEOUT(changed.count(), 2, kPatience);
        session.document().reload();
        QThread::msleep(300);
        QVERIFY(QFile::remove(file));
        QVERIFY(openingIsOver(session));
        QTRY_VERIFY_WITH_TIMEOUT(session.document().modified(), kPatience); // the window has the only copy
    }

    void fitsTheStockToTheProgram() {
        QTemporaryDir folder;
        Session session;
        QVERIFY(opened(session, write(folder, "square.nc", kSquare)));
        QTRY_VERIFY_WITH_TIMEOUT(session.program().current() != nullptr, kPatience);
        const StockBox stock = session.job().setup().stock;
        QCOMPARE(stock.corner, Vec3(-5, -5, 0)); // no cutter is known: 5 mm around
        QCOMPARE(stock.width, 20.0);
        QCOMPARE(stock.height, 6.0); // 1 mm of cut and 5 mm below it
        const std::vector<ToolChangeMark> marks = toolChangeMarks(*session.program().current());
        QCOMPARE(marks.size(), std::size_t{1});
        QCOMPARE(marks.front().block, std::size_t{0});
    }

    void marksOfManyToolChangesAreFew() {
        Program program;
        Motion motion;
        motion.startKnown = motion.endKnown = kAllAxes;
        constexpr std::size_t kChanges = 20'000;
        for (std::size_t k = 0; k < kChanges; ++k) {
            program.append(ToolChange{static_cast<int>(k)}, 1);
            program.append(Dwell{1}, 1);
            program.beginBlock(1);
            motion.start = motion.end;
            motion.end.x += 1;
            program.append(motion);
        }
        const std::vector<ToolChangeMark> marks = toolChangeMarks(program);
        QVERIFY(marks.size() <= kMostMarks && marks.size() > kMostMarks / 2);
        QVERIFY(marks.front().block == 0 && marks.back().block > kChanges - 20);
        QVERIFY(neighbouringToolChange(program, 7000, -1) == std::size_t{6999});
        QVERIFY(neighbouringToolChange(program, 7000, 1) == std::size_t{7001});
        QVERIFY(!neighbouringToolChange(program, 0, -1));
        QVERIFY(!neighbouringToolChange(program, kChanges - 1, 1));
    }

    /// An assumed tool counts with its width, like a tool that the program calls.
    void fitsTheStockToTheToolThatIsAssumed() {
        QTemporaryDir folder;
        Session session;
        QVERIFY(opened(session, write(folder, "square.nc", "(T1 D=50. FLAT)\n" + kUncalled)));
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame() != nullptr, kPatience);
        QCOMPARE(session.job().setup().tools.find(1)->radius(), 25.0);
        QVERIFY(session.simulation().frame()->toolAssumed);
        QCOMPARE(session.job().setup().stock.corner, Vec3(-25, -25, 0));
        QCOMPARE(session.job().setup().stock.width, 60.0);
        QCOMPARE(session.job().stockFittedToProgram().width, 60.0);
    }

    /// G41 without D uses the tool in the spindle, which is the assumed one.
    void compensatesForTheToolThatIsAssumed() {
        QTemporaryDir folder;
        Session session;
        QVERIFY(opened(session, write(folder, "comp.nc",
                                      "(T1 D=4. FLAT)\nG21 G90\nG0 X0 Y-20 Z5\nG1 Z-1 F100\n"
                                      "G41 G1 X0 Y0\nY20\nY40\nG40 X20\nM2\n")));
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame() != nullptr, kPatience);
        QCOMPARE(session.program().current()->motion(3).end.x, -2.0);
        QVERIFY(!hasProblem(session, "compensation-without-diameter"));
        QVERIFY(hasProblem(session, "tool-assumed"));
        QSignalSpy read(&session.program(), &ProgramHub::changed);
        session.document().applyEdit(0, 0, "(edited)\n");
        QTRY_VERIFY_WITH_TIMEOUT(!read.isEmpty(), kPatience);
        QCOMPARE(session.program().current()->motion(3).end.x, -2.0);
        Setup empty = session.job().setup();
        empty.startTool = 0;
        read.clear();
        QVERIFY(session.job().setSetup(empty).has_value());
        QTRY_VERIFY_WITH_TIMEOUT(!read.isEmpty(), kPatience);
        QCOMPARE(session.program().current()->motion(3).end.x, 0.0);
    }

    void aNewProgramInheritsNothing() {
        QTemporaryDir folder;
        Session session;
        QVERIFY(opened(session, write(folder, "first.nc", kSquare)));
        Setup setup = session.job().setup();
        setup.tools.set(1, parseCutter("ball:d=10,l=30").value());
        QVERIFY(session.job().setSetup(setup));
        DecimationParameters parameters;
        parameters.allowance = 0.3;
        session.job().setParameters(parameters);
        QVERIFY(opened(session, write(folder, "second.nc", kSquare)));
        QVERIFY(session.job().setup().tools.tools().empty());
        QCOMPARE(session.job().parameters().allowance, DecimationParameters{}.allowance);
        QVERIFY(opened(session, kSample));
        session.document().newFile();
        QVERIFY(session.job().setup().tools.tools().empty());
        QVERIFY(session.document().jobFile().isEmpty());
        QVERIFY(!session.document().modified());
    }

    void savesProgramAndJobTogether() {
        QTemporaryDir folder;
        Session session;
        QVERIFY(opened(session, write(folder, "square.nc", kSquare)));
        QVERIFY(session.document().saveJobAs(folder.filePath("square.proveout")));
        QVERIFY(!session.document().modified());
        DecimationParameters parameters;
        parameters.allowance = 0.3;
        session.job().setParameters(parameters);
        session.document().applyEdit(0, 0, "(a)\n");
        session.document().setTextModified(true);
        QVERIFY(session.document().jobModified() && session.document().text().modified);
        QVERIFY(session.document().save());
        QVERIFY(!session.document().modified());
        QCOMPARE(bytesOf(folder.filePath("square.nc")), "(a)\n" + kSquare);
        QVERIFY(opened(session, folder.filePath("square.proveout")));
        QCOMPARE(session.job().parameters().allowance, 0.3);
        // After saving under another name, the job must refer to the new program.
        QVERIFY(session.document().saveAs(folder.filePath("other.nc")));
        QVERIFY(session.document().jobModified());
        QVERIFY(session.document().save());
        Session again;
        QVERIFY(opened(again, folder.filePath("square.proveout")));
        QCOMPARE(QFileInfo(toQString(again.document().text().path)).fileName(), QString("other.nc"));
    }

    void reportsFieldsOfAJobThatAreNotKnown() {
        QTemporaryDir folder;
        Session session;
        QVERIFY(opened(session, write(folder, "square.nc", kSquare)));
        const QString job = folder.filePath("square.proveout");
        QVERIFY(session.document().saveJobAs(job));
        write(folder, "square.proveout", bytesOf(job).replace("\"allowance\"", "\"allowence\""));
        QVERIFY(opened(session, job));
        QVERIFY2(!session.problems().all().empty(), "a misspelt field is no reason to be silent");
        const Diagnostic& problem = session.problems().all().front();
        QCOMPARE(problem.severity, Severity::warning);
        QVERIFY(sentence(problem).contains(QLatin1String("allowence")));
        QVERIFY(!ProblemsHub::isInText(problem));
    }

    void problemsKeepTheirPlaceUnderAnotherName() {
        QTemporaryDir folder;
        Session session;
        QVERIFY(opened(session, write(folder, "a.nc", "G0 X0\nG1 X10 Q5\nM30\n")));
        const auto inText = [&session] {
            return std::count_if(session.problems().all().begin(), session.problems().all().end(),
                                 &ProblemsHub::isInText);
        };
        QTRY_VERIFY_WITH_TIMEOUT(inText() > 0, kPatience);
        const auto before = inText();
        QVERIFY(session.document().saveAs(folder.filePath("b.nc")));
        QCOMPARE(inText(), before);
    }

    void findingsMoveWithTheirLines() {
        QTemporaryDir folder;
        Session session;
        QVERIFY(opened(session, write(folder, "rapid.nc", kSquare)));
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame() != nullptr, kPatience);
        const auto lineOf = [&session](const char* id) {
            for (const Diagnostic& problem : session.problems().all())
                if (std::string(problem.id) == id)
                    return problem.where.line;
            return 0;
        };
        const char* id = session.simulation().frame()->findings.front().id;
        const int before = lineOf(id);
        QVERIFY(before > 0);
        session.document().applyEdit(0, 0, "(one line more)\n");
        QTRY_COMPARE_WITH_TIMEOUT(lineOf(id), before + 1, kPatience);
    }

    void playingEndsWhereNothingPlays() {
        Session session;
        QVERIFY(opened(session, kSample));
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame() != nullptr, kPatience);
        session.playback().seek(100);
        QTRY_COMPARE_WITH_TIMEOUT(session.simulation().block(), std::size_t{100}, kPatience);
        session.playback().setSpeed(1);
        session.playback().play();
        session.work().cancel();
        QVERIFY(!session.playback().state().playing);

        // A setup that requires the program to be interpreted again keeps position and playback.
        session.playback().play();
        Setup setup = session.job().setup();
        setup.blockDelete = !setup.blockDelete;
        const FramePtr before = session.simulation().frame();
        QVERIFY(session.job().setSetup(setup).has_value());
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame()->setup->blockDelete == setup.blockDelete &&
                                     session.simulation().block() >= 100,
                                 kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame()->playing, kPatience);
        QVERIFY(session.playback().state().playing);
    }

    void aLoadThatFailsIsNotPlayed() {
        QTemporaryDir folder;
        Session source;
        QVERIFY(opened(source, kSample));
        QVERIFY(source.document().saveJobAs(folder.filePath("large.proveout")));
        QJsonObject job = QJsonDocument::fromJson(bytesOf(folder.filePath("large.proveout"))).object();
        job["grid"] = 0.0005;
        Session session;
        QVERIFY(opened(session, write(folder, "large.proveout", QJsonDocument(job).toJson())));
        QTRY_VERIFY_WITH_TIMEOUT(hasProblem(session, "grid-too-fine"), kPatience);
        session.playback().play();
        QTRY_VERIFY_WITH_TIMEOUT(!session.playback().state().playing, kPatience);
        QVERIFY(session.simulation().frame() == nullptr);
    }

    void fault36ADeletedFileIsNotLost() {
        QTemporaryDir folder;
        Session session;
        const QString file = write(folder, "square.nc", kSquare);
        QVERIFY(opened(session, file));
        QVERIFY(QFile::remove(file));
        QTRY_VERIFY_WITH_TIMEOUT(session.document().modified(), kPatience);
        session.document().reload();
        QVERIFY(openingIsOver(session));
        QVERIFY(session.document().modified());
        QVERIFY(session.document().save());
        QCOMPARE(bytesOf(file), kSquare);
        QVERIFY(!session.document().modified());
    }

    void oneExportAtATime() {
        QTemporaryDir folder;
        Session session;
        QVERIFY(opened(session, kSample));
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame() != nullptr, kPatience);
        QSignalSpy exported(&session.exports(), &ExportHub::exported);
        session.exports().exportMesh(folder.filePath("first.stl"), {});
        session.exports().exportMesh(folder.filePath("second.stl"), {});
        QVERIFY(hasProblem(session, "export-running"));
        QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 1, kPatience);
        QVERIFY(QFile::exists(folder.filePath("first.stl")));
        QVERIFY(!QFile::exists(folder.filePath("second.stl")));
    }

    void anInterpreterThatThrowsIsReportedAndTheNextTextIsRead() {
        ProgramSource source(nullptr,
                             [](const NcText& text, const InterpretOptions& options,
                                const WorkContext& context,
                                const PublishBeginning&) -> std::shared_ptr<const Program> {
                                 if (text.size() == 0)
                                     throw std::bad_alloc();
                                 return interpret(text, options, context);
                             });
        QSignalSpy failed(&source, &ProgramSource::failed);
        QSignalSpy ready(&source, &ProgramSource::ready);
        source.request(NcText(), {});
        QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 1, kPatience);
        source.request(NcText("M30\n"), {});
        QTRY_COMPARE_WITH_TIMEOUT(ready.count(), 1, kPatience);
    }

    void theBeginningOfALongProgramIsThereBeforeTheRest() {
        QTemporaryDir folder;
        Session session;
        std::vector<std::size_t> counts;
        bool reported = false;
        connect(&session.program(), &ProgramHub::changed, this, [&] {
            if (!session.program().current())
                return;
            counts.push_back(session.program().blockCount());
            reported = reported || hasProblem(session, "still-reading");
        });
        connect(&session.problems(), &ProblemsHub::changed, this,
                [&] { reported = reported || hasProblem(session, "still-reading"); });
        QVERIFY(opened(session, write(folder, "long.nc", longProgram(600'000))));
        QTRY_COMPARE_WITH_TIMEOUT(session.program().blockCount(), std::size_t{600'003}, kPatience);
        QVERIFY(counts.size() >= 2);
        QVERIFY(counts.front() < 150'000);
        QVERIFY(reported);
        QVERIFY(!hasProblem(session, "still-reading"));
        QVERIFY(!session.work().current());
        // The stock fits the whole program.
        QVERIFY(session.job().setup().stock.depth > 299);
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame() &&
                                     session.simulation().frame()->program == session.program().current(),
                                 kPatience);
    }

    void readingALongProgramCanBeCancelled() {
        QTemporaryDir folder;
        Session session;
        connect(&session.work(), &WorkHub::changed, this, [&] {
            if (session.work().current() &&
                session.work().current()->label == Session::tr("Reading the program"))
                session.work().cancel();
        });
        QVERIFY(opened(session, write(folder, "long.nc", longProgram(3'000'000))));
        QTRY_VERIFY_WITH_TIMEOUT(hasProblem(session, "interpretation-stopped"), kPatience);
        QVERIFY(session.program().blockCount() < 2'900'000);
        QVERIFY(!hasProblem(session, "still-reading"));
    }

    void theEventLoopGoesRoundWhileALongFileIsOpened() {
        QTemporaryDir folder;
        const QString file = write(folder, "long.nc", longProgram(3'000'000));
        Session session;
        QVERIFY(opened(session, write(folder, "square.nc", kSquare)));
        int reported = 0;
        connect(&session.work(), &WorkHub::changed, this, [&] {
            reported +=
                session.work().current() && session.work().current()->label == Session::tr("Opening the file")
                    ? 1
                    : 0;
        });
        int rounds = 0;
        QTimer round;
        connect(&round, &QTimer::timeout, this, [&] { ++rounds; });
        round.start(0);
        bool through = false;
        connect(&session.document(), &DocumentHub::opened, this, [&] { through = true; });
        session.document().openFile(file);
        QVERIFY(session.document().isOpening());
        while (session.document().isOpening())
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        QVERIFY(through);
        QVERIFY2(rounds > 10, qPrintable(QString::number(rounds)));
        QVERIFY(reported >= 2);
        QCOMPARE(session.document().text().path, toPath(file));
    }

    void anOpeningThatIsCancelledLeavesTheDocument() {
        QTemporaryDir folder;
        Session session;
        QVERIFY(opened(session, write(folder, "square.nc", kSquare)));
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame() != nullptr, kPatience);
        QSignalSpy replaced(&session.document(), &DocumentHub::textReplaced);
        bool cancelled = false;
        connect(&session.work(), &WorkHub::changed, this, [&] {
            if (session.work().current() &&
                session.work().current()->label == Session::tr("Opening the file")) {
                cancelled = true;
                session.work().cancel();
            }
        });
        QVERIFY(!opened(session, write(folder, "long.nc", longProgram(3'000'000))));
        QVERIFY(cancelled);
        QTest::qWait(100); // lets pending work finish
        QCOMPARE(replaced.count(), 0);
        QVERIFY(!session.work().current());
        QCOMPARE(session.document().text().path, toPath(folder.filePath("square.nc")));
        QCOMPARE(session.document().text().text.toString(), kSquare.toStdString());
        QVERIFY(session.simulation().frame() != nullptr);
    }

    void theNewestFileIsTheOneThatIsOpened() {
        QTemporaryDir folder;
        const QString file = write(folder, "long.nc", longProgram(3'000'000));
        Session session;
        QSignalSpy spy(&session.document(), &DocumentHub::opened);
        session.document().openFile(file);
        session.document().openFile(file);
        QVERIFY(opened(session, write(folder, "square.nc", kSquare)));
        QTRY_VERIFY_WITH_TIMEOUT(session.program().blockCount() > 0, kPatience);
        QCOMPARE(spy.count(), 1);
        QCOMPARE(session.document().text().path, toPath(folder.filePath("square.nc")));
        session.document().openFile(file);
        session.document().newFile();
        QVERIFY(!session.document().isOpening());
        QTest::qWait(100);
        QVERIFY(session.document().text().path.empty());
    }

    void aChangeWhileAFileIsReadIsNotLost_data() {
        QTest::addColumn<int>("change");
        QTest::newRow("text") << 0;
        QTest::newRow("set-up") << 1;
        QTest::newRow("parameters") << 2;
    }
    void aChangeWhileAFileIsReadIsNotLost() {
        QFETCH(int, change);
        QTemporaryDir folder;
        const QString file = write(folder, "long.nc", longProgram(3'000'000));
        Session session;
        QVERIFY(opened(session, write(folder, "square.nc", kSquare)));
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame() != nullptr, kPatience);
        session.document().openFile(file);
        Setup setup = session.job().setup();
        setup.automaticGrid = false;
        setup.spacing *= 2;
        DecimationParameters parameters = session.job().parameters();
        parameters.allowance = 0.3;
        if (change == 0)
            session.document().applyEdit(0, 0, "(mine)\n");
        else if (change == 1)
            QVERIFY(session.job().setSetup(setup));
        else
            session.job().setParameters(parameters);
        QVERIFY(!session.document().isOpening());
        QVERIFY(hasProblem(session, "opening-stopped"));
        QTest::qWait(100);
        QCOMPARE(session.document().text().path, toPath(folder.filePath("square.nc")));
        QCOMPARE(session.document().text().text.toString(),
                 (change == 0 ? "(mine)\n" : "") + kSquare.toStdString());
        QCOMPARE(session.job().setup().spacing == setup.spacing, change == 1);
        QCOMPARE(session.job().parameters() == parameters, change == 2);
    }

    void aSessionMayEndWhileAFileIsRead() {
        QTemporaryDir folder;
        const QString file = write(folder, "long.nc", longProgram(3'000'000));
        Session session;
        session.document().openFile(file);
    }

    void keepsMineUntilItIsSaved() {
        QTemporaryDir folder;
        Session session;
        QVERIFY(opened(session, write(folder, "square.nc", kSquare)));
        session.document().keepMine();
        QVERIFY(session.document().modified());
        session.document().setTextModified(false); // undo has reached the text as it was read
        QVERIFY(session.document().modified());
        QVERIFY(session.document().save());
        QVERIFY(!session.document().modified());
    }

    void aFailedOpenIsReportedWithItsFile() {
        QTemporaryDir folder;
        Session session;
        QVERIFY(opened(session, write(folder, "square.nc", kSquare)));
        QSignalSpy troubled(&session.problems(), &ProblemsHub::troubled);
        QVERIFY(!opened(session, write(folder, "picture.nc", QByteArray(64, '\0'))));
        QCOMPARE(troubled.count(), 1);
        const Diagnostic& problem = session.problems().all().front();
        QCOMPARE(problem.where.line, 0); // it does not refer to a line of the open program
        QVERIFY2(sentence(problem).startsWith(QLatin1String("picture.nc: ")), qPrintable(sentence(problem)));
    }

    void speedsGoUpAndDown() {
        QCOMPARE(neighbourSpeed(kUnitBlocksPerSecond, 1), 2 * kUnitBlocksPerSecond);
        QCOMPARE(neighbourSpeed(kUnitBlocksPerSecond, -1), 0.5 * kUnitBlocksPerSecond);
        QVERIFY(std::isinf(neighbourSpeed(1e9, 1)));
        QCOMPARE(neighbourSpeed(speeds().front(), -1), speeds().front());
    }
};

} // namespace proveout

QTEST_MAIN(proveout::SessionTest)
#include "session_test.moc"
