// SPDX-License-Identifier: GPL-3.0-or-later
// The event loop must keep running while a large program is played, sought, loaded again or stopped. Other
// load on the machine lengthens every gap, so wall time alone decides nothing: the computing of the UI thread
// between two beats is measured by its CPU time, and its waiting by how much a control thread was delayed in
// the same seconds.
#include <algorithm>
#include <atomic>
#include <memory>
#include <random>
#include <stop_token>
#include <thread>
#include <vector>

#include <QApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include "tests/ui/window/heartbeat.h"
#include "tests/ui/window/workstation.h"

namespace proveout {
namespace {

constexpr double kLongestGapMs = 250; // with OpenGL in software; applies to 99 % of the gaps

/// The value that 99 % of the values do not exceed.
double percentile99(std::vector<double> values) {
    std::ranges::sort(values);
    return values.empty() ? 0 : values[values.size() * 99 / 100];
}

/// A thread that does small computations at intervals, and measures how much longer they take than without
/// other load.
class Control {
public:
    Control() : m_thread([this](const std::stop_token& stop) { run(stop); }) {}
    [[nodiscard]] double stretch() const { return std::max(1.0, m_wallMs / std::max(1.0, m_cpuMs.load())); }

private:
    void run(const std::stop_token& stop) {
        while (!stop.stop_requested()) {
            QElapsedTimer wall;
            wall.start();
            const double begin = threadCpuMs();
            while (threadCpuMs() - begin < kBurstMs) {
            }
            m_cpuMs = m_cpuMs + threadCpuMs() - begin;
            m_wallMs = m_wallMs + 1e-6 * static_cast<double>(wall.nsecsElapsed());
            std::this_thread::sleep_for(std::chrono::milliseconds(80));
        }
    }

    static constexpr double kBurstMs = 10;
    std::atomic<double> m_wallMs = 0;
    std::atomic<double> m_cpuMs = 0;
    std::jthread m_thread; ///< last member: it must end before what it writes to is destroyed
};

/// Heartbeat and control thread together, evaluated once.
class Breath {
public:
    [[nodiscard]] bool isLong() const { return m_heart.gaps().size() >= 100; }
    /// The longest time in ms that the UI thread has computed without processing events.
    [[nodiscard]] double longestComputed() const {
        return m_heart.computed().empty() ? 0 : std::ranges::max(m_heart.computed());
    }
    /// Prints the figures.
    [[nodiscard]] bool isEven() {
        m_heart.stop();
        std::vector<double> gaps = m_heart.gaps();
        const double gap = percentile99(gaps);
        const double computed = percentile99(m_heart.computed());
        std::ranges::sort(gaps);
        qInfo(
            "%zu gaps: half under %.0f ms, 99 %% under %.0f ms, of which computed %.0f ms; longest %.0f ms; "
            "the machine takes %.2f times as long as it would alone",
            gaps.size(), gaps[gaps.size() / 2], gap, computed, gaps.back(), m_control.stretch());
        return computed <= kLongestGapMs && gap <= kLongestGapMs * m_control.stretch();
    }

private:
    const Control m_control;
    Heartbeat m_heart;
};

} // namespace

class BreathingTest : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings = std::make_unique<OwnSettings>(); }

    void theEventLoopBreathesWhilePlaying() {
        Workstation station(true);
        openLargeSample(station);
        const std::size_t from = station.session.simulation().block();
        Breath breath;
        station.session.playback().play();
        QTest::qWait(4000);
        // A busy machine allows fewer beats in that time, so this waits for enough beats that 1 % of them is
        // meaningful.
        QTRY_VERIFY_WITH_TIMEOUT(breath.isLong() && station.session.simulation().block() > from + 500,
                                 kPatience);
        station.session.playback().pause();
        QVERIFY2(breath.isEven(), "too long gaps while playing");
    }

    /// 500 seeks in two seconds through the timeline.
    void theEventLoopBreathesInAStormOfSeeks() {
        Workstation station(true);
        openLargeSample(station);
        std::mt19937 random(7);
        Breath breath;
        int seeks = 0;
        QTimer storm;
        connect(&storm, &QTimer::timeout, this, [&] {
            station.session.playback().seek(random() % (station.session.program().blockCount() + 1));
            if (++seeks == 500)
                storm.stop();
        });
        storm.start(4);
        QTRY_VERIFY_WITH_TIMEOUT(seeks == 500 && breath.isLong(), kPatience);
        station.session.playback().seek(4321);
        QTRY_COMPARE_WITH_TIMEOUT(station.session.simulation().block(), std::size_t{4321}, kPatience);
        QVERIFY2(breath.isEven(), "too long gaps in a storm of seeks");
    }

    void theEventLoopBreathesWhileTheGridChanges() {
        Workstation station(true);
        openLargeSample(station);
        station.session.playback().play();
        Breath breath;
        for (const double spacing : {0.5, 0.3, 0.8, 0.4}) {
            Setup setup = station.session.job().setup();
            setup.automaticGrid = false;
            setup.spacing = spacing;
            QVERIFY(station.session.job().setSetup(setup).has_value());
            QTest::qWait(600);
            QVERIFY(station.session.playback().state().playing);
        }
        QTRY_VERIFY_WITH_TIMEOUT(breath.isLong(), kPatience);
        // Playback continues from the same block, on the new z-map.
        QTRY_COMPARE_WITH_TIMEOUT(station.session.simulation().frame()->setup->spacing, 0.4, kPatience);
        station.session.playback().pause();
        QVERIFY2(breath.isEven(), "too long gaps while the grid changes");
    }

    void theEventLoopBreathesThroughACancel() {
        Workstation station(true);
        openLargeSample(station);
        Breath breath;
        for (int run = 0; run < 5; ++run) {
            station.session.playback().seek(0);
            QTest::qWait(100);
            station.session.playback().seek(station.session.program().blockCount());
            QTest::qWait(100 + 60 * run);
            station.session.work().cancel();
            QTest::qWait(200);
        }
        QTRY_VERIFY_WITH_TIMEOUT(breath.isLong(), kPatience);
        station.session.playback().seek(100);
        QTRY_COMPARE_WITH_TIMEOUT(station.session.simulation().block(), std::size_t{100}, kPatience);
        QVERIFY2(breath.isEven(), "too long gaps through a cancel");
    }

    /// A few bytes that specify millions of motions: the window must respond while they are read, report the
    /// problem, and show no more motions than can be drawn.
    void theEventLoopBreathesThroughEndlessPrograms_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("id");
        const QByteArray begin = "G21 G90 G17 F100\nG0 X0 Y0 Z5\n";
        QTest::newRow("pecks") << begin + "G83 X1 Y1 Z-10 R1 Q0.0000001\nM2\n"
                               << QByteArray("block-too-long");
        QTest::newRow("repeats") << begin + "G91 G81 X1 Z-1 R0 L999999999\nM2\n"
                                 << QByteArray("block-too-long");
        QTest::newRow("calls") << begin + "M98 P2 L9999\nM2\nO2\nM98 P3 L9999\nM99\nO3\nG91 G0 X1\nM99\n"
                               << QByteArray("too-many-steps");
        QTest::newRow("loop") << begin + "o1 while [1]\nG91 G1 X1\no1 endwhile\nM2\n"
                              << QByteArray("endless-loop");
        QTest::newRow("counting loop")
            << begin + "#1=0\no1 while [1]\n#1=[#1+1]\nG1 X[#1 MOD 90]\no1 endwhile\nM2\n"
            << QByteArray("too-many-steps");
        QTest::newRow("loop of tool changes")
            << begin + "#1=0\no1 while [1]\n#1=[#1+1]\nT1 M6\nT2 M6\nG91 G0 X1\no1 endwhile\nM2\n"
            << QByteArray("too-many-again");
        QTest::newRow("idle loop") << begin + "#1=0\no1 while [1]\n#1=[#1+1]\no1 endwhile\nM2\n"
                                   << QByteArray("loop-without-motion");
    }
    void theEventLoopBreathesThroughEndlessPrograms() {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, id);
        const auto isReported = [&](const Session& session) {
            return std::ranges::any_of(session.problems().all(), [&](const Diagnostic& problem) {
                return id == problem.id && ProblemsHub::isInText(problem);
            });
        };
        constexpr std::size_t kFew = 10'000; // motions; stopping at repeated messages leaves some thousand
        Workstation station(true);
        QTest::qWait(1000); // the first frame compiles shaders
        const FramePtr before = station.session.simulation().frame();
        {
            Breath breath;
            station.session.document().applyEdit(0, station.session.document().text().text.size(),
                                                 text.toStdString());
            QVERIFY(station.session.simulation().frame() == before); // stays until the new one is read
            QTRY_VERIFY_WITH_TIMEOUT(isReported(station.session), kPatience);
            QTest::qWait(1000); // time for cutting and drawing
            QVERIFY2(breath.longestComputed() <= kLongestGapMs,
                     qPrintable(QString::number(breath.longestComputed())));
        }
        QVERIFY(station.session.program().current()->motionCount() < kFew);

        QTemporaryDir folder;
        QFile file(folder.filePath(QStringLiteral("endless.ngc")));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
        file.close();
        const auto openEndless = [&] {
            station.session.document().openFile(file.fileName());
            return QTest::qWaitFor(
                [&] {
                    return station.session.document().text().path == file.fileName().toStdString() &&
                           isReported(station.session);
                },
                kPatience);
        };
        // Its frame uses other shaders, which are compiled once, with software rendering on this thread.
        QVERIFY(openEndless());
        QTest::qWait(1000);
        station.open(sampleJobs().front().file);
        QTest::qWait(1000); // its walls, drawn at rest, use another shader
        const Breath breath;
        QVERIFY(openEndless());
        QTest::qWait(1000);
        QVERIFY2(breath.longestComputed() <= kLongestGapMs,
                 qPrintable(QString::number(breath.longestComputed())));
        QCOMPARE(QByteArray::fromStdString(station.session.document().text().text.toString()), text);
    }

private:
    static void openLargeSample(Workstation& station) {
        station.open(sampleJobs().back().file);
        if (station.session.program().blockCount() != 10'273)
            qFatal("this is another sample");
        // By blocks, because by time the program would end before a busy machine has changed the grid four
        // times.
        station.session.playback().setPlayBy(PlayBy::blocks);
        station.session.playback().setSpeed(1000);
        QTest::qWait(1000); // the first frame compiles shaders
    }

    std::unique_ptr<OwnSettings> m_settings;
};

} // namespace proveout

int main(int argc, char** argv) {
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QApplication application(argc, argv);
    proveout::BreathingTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "breathing_test.moc"
