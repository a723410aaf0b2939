// SPDX-License-Identifier: GPL-3.0-or-later
// window_run NAME JOB [SECONDS [edit]]: the workstation's window opens a job, runs it to its end, jumps to
// and fro, and plays it for some seconds at two speeds; `edit`: replaces one letter everywhere and saves the
// program under another name. Prints a row of a table for each of these, with the gaps of the event loop.
// Exits with 1 if one of them does not come to its end, or if its thread computes for more than 250 ms in 1 %
// of the gaps; other load on the machine lengthens the gaps themselves. Needs a display.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <QApplication>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QMetaEnum>

#include "core/base/memory.h"
#include "tests/ui/window/heartbeat.h"
#include "tests/ui/window/workstation.h"
#include "ui/editor/editor_panel.h"
#include "ui/editor/editor_search.h"
#include "ui/editor/nc_editor.h"

namespace {

using namespace proveout;

constexpr double kMostMs = 250; // with OpenGL in software; for 99 % of the gaps
constexpr double kMegabyte = 1e6;
constexpr int kLongestMs = 600'000;
constexpr double kPlayedPerSecond = 1000; ///< blocks
constexpr int kBetweenJumpsMs = 100;

/// Measures how long this thread computes for each event, and remembers the longest.
class TimedApplication final : public QApplication {
public:
    using QApplication::QApplication;

    bool notify(QObject* receiver, QEvent* event) override {
        if (m_inside)
            return QApplication::notify(receiver, event);
        m_inside = true;
        // The receiver may be deleted by its event.
        const char* const receiverClass = receiver->metaObject()->className();
        const QEvent::Type type = event->type();
        const double begin = threadCpuMs();
        const bool handled = QApplication::notify(receiver, event);
        if (const double taken = threadCpuMs() - begin; taken > m_longest) {
            m_longest = taken;
            const char* const name = QMetaEnum::fromType<QEvent::Type>().valueToKey(type);
            m_name = fmt::format("{} {}", receiverClass, name != nullptr ? name : std::to_string(type));
        }
        m_inside = false;
        return handled;
    }
    /// The longest event since the last call.
    std::string takeLongest() {
        return fmt::format("{} {:.0f} ms", std::exchange(m_name, {}), std::exchange(m_longest, 0));
    }

private:
    bool m_inside = false;
    double m_longest = 0;
    std::string m_name;
};

/// The value that 99 % of the values do not exceed.
double percentile99(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() * 99 / 100];
}

/// One row of the table, from its construction to report().
class Phase {
public:
    Phase(TimedApplication& application, std::string program, const char* what)
        : m_application(application), m_program(std::move(program)), m_what(what) {
        (void)m_application.takeLongest();
        m_clock.start();
    }
    /// `reached`: whether the phase came to its end.
    bool report(bool reached) {
        const double seconds = 1e-9 * static_cast<double>(m_clock.nsecsElapsed());
        m_heart.stop();
        const std::vector<double>& gaps = m_heart.gaps();
        const bool fine = reached && percentile99(m_heart.computed()) <= kMostMs;
        fmt::print("| {} | {} | {:.1f} | {:.0f} | {:.0f} | {:.0f} | {:.0f} | {} |{}\n", m_program, m_what,
                   seconds, percentile99(gaps), std::ranges::max(gaps), std::ranges::max(m_heart.computed()),
                   static_cast<double>(peakMemoryBytes()) / kMegabyte, m_application.takeLongest(),
                   fine ? "" : " **too slow, or not reached**");
        std::fflush(stdout);
        return fine;
    }

private:
    TimedApplication& m_application;
    std::string m_program;
    const char* m_what;
    QElapsedTimer m_clock;
    Heartbeat m_heart;
};

bool reached(const std::function<bool()>& there) {
    return QTest::qWaitFor(there, kLongestMs);
}

bool isOpen(Workstation& station) {
    const Session& session = station.session;
    return !session.document().isOpening() && session.program().current() && !session.program().isReading() &&
           !station.window.editor().editor().isFilling() && session.simulation().frame() &&
           session.simulation().frame()->program == session.program().current();
}

/// Whether the stock after `block` has been drawn.
bool isSeen(Workstation& station, std::size_t block) {
    const auto& drawn = station.session.playback().frameStatistics();
    return station.session.simulation().block() == block && !drawn.empty() && drawn.back().lastBlock == block;
}

/// Plays from the start for some seconds, or to the end.
bool play(Workstation& station, double blocksPerSecond, int seconds) {
    PlaybackHub& playback = station.session.playback();
    playback.setPlayBy(PlayBy::blocks);
    playback.setSpeed(blocksPerSecond);
    playback.play();
    (void)QTest::qWaitFor([&] { return !playback.state().playing; }, 1000 * seconds);
    playback.pause();
    return station.session.simulation().block() > 0;
}

bool jumpToAndFro(Workstation& station, int seconds) {
    std::mt19937 random(7);
    QElapsedTimer clock;
    clock.start();
    while (clock.elapsed() < 1000 * seconds) {
        station.session.playback().seek(random() % (station.session.program().blockCount() + 1));
        QTest::qWait(kBetweenJumpsMs);
    }
    return true;
}

bool replaceAll(Workstation& station) {
    EditorSearch search(station.window.editor().editor(), &station.window);
    search.setPattern(QStringLiteral("Y"), false);
    const auto proceed = [](double) {
        QCoreApplication::processEvents(); // as the progress dialog of the find bar does
        return true;
    };
    return search.replaceAll(QStringLiteral("y"), proceed) > 0 && reached([&] { return isOpen(station); });
}

bool save(Workstation& station) {
    const QTemporaryDir folder;
    return station.session.document().saveAs(folder.filePath(QStringLiteral("saved.nc")));
}

bool runAll(TimedApplication& application, const std::string& name, const QString& job, int seconds,
            bool edit) {
    Workstation station(false);
    station.window.findChild<QDockWidget*>(QStringLiteral("dock-plots"))->raise();
    QTest::qWait(1000);
    bool fine = true;
    const auto measure = [&](const char* what, const std::function<bool()>& work) {
        Phase phase(application, name, what);
        fine = phase.report(work()) && fine;
    };
    measure("open",
            [&] { return station.window.files().open(job) && reached([&] { return isOpen(station); }); });
    PlaybackHub& playback = station.session.playback();
    const std::size_t end = station.session.program().blockCount();
    measure("to the end", [&] {
        playback.seek(end);
        return reached([&] { return isSeen(station, end); });
    });
    measure("at the end", [&] {
        QTest::qWait(1000 * seconds);
        return reached([&] { return !station.session.work().current(); });
    });
    measure("jump to and fro", [&] { return jumpToAndFro(station, seconds); });
    playback.seek(0);
    fine = reached([&] { return station.session.simulation().block() == 0; }) && fine;
    measure("play 1000 blocks/s", [&] { return play(station, kPlayedPerSecond, seconds); });
    measure("play as fast as possible",
            [&] { return play(station, std::numeric_limits<double>::infinity(), seconds); });
    if (edit) {
        measure("replace all", [&] { return replaceAll(station); });
        measure("save", [&] { return save(station); });
    }
    return fine;
}

} // namespace

int main(int argc, char** argv) {
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    const proveout::OwnSettings settings;
    TimedApplication application(argc, argv);
    if (argc < 3) {
        fmt::print(stderr, "window_run NAME JOB [SECONDS [edit]]\n");
        return EXIT_FAILURE;
    }
    const int seconds = argc > 3 ? std::atoi(argv[3]) : 5;
    const bool fine = runAll(application, argv[1], QString::fromLocal8Bit(argv[2]), seconds, argc > 4);
    return fine ? EXIT_SUCCESS : EXIT_FAILURE;
}
