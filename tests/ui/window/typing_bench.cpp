// SPDX-License-Identifier: GPL-3.0-or-later
// From a key to its squiggle: the workstation with a program of 100 000 lines, something wrong typed at the
// end of random ones. Prints how long opening takes, for how long at a time the window does not answer
// meanwhile, and percentiles in milliseconds. A program that is shown read-only is only opened, and so is a
// file that is named.
//     typing_bench [KEYS] [LINES | FILE]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <random>
#include <utility>
#include <vector>

#include <QApplication>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include "ui/editor/editor_panel.h"
#include "ui/editor/nc_editor.h"
#include "ui/look/appearance.h"
#include "ui/window/main_window.h"

using namespace proveout;

namespace {

constexpr double kPatienceMs = 60'000;
constexpr double kOpeningMs = 900'000; ///< of a file of a gigabyte on a busy machine
constexpr int kShort = 1000;           ///< lines

/// A finishing pass as a CAM system writes it.
void writeProgram(const std::string& file, int lines) {
    std::ofstream out(file);
    out.precision(6);
    out << "G21 G90 G17 T1 M6 S8000 M3 F3000\nG0 X0 Y0 Z10\nG1 Z0\n";
    for (int i = 0; i < lines - 5; ++i) {
        const double t = i * 1e-3;
        out << "X" << 100 * std::sin(t) << " Y" << 100 * std::cos(t) << " Z" << -5 + std::sin(7 * t) << "\n";
    }
    out << "G0 Z10\nM30\n";
}

/// Milliseconds until it is so.
double until(const std::function<bool()>& done, double patience = kPatienceMs) {
    QElapsedTimer timer;
    timer.start();
    const auto elapsed = [&] { return static_cast<double>(timer.nsecsElapsed()) * 1e-6; };
    while (!done() && elapsed() < patience)
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents | QEventLoop::AllEvents, 1);
    return elapsed();
}

/// Milliseconds that this thread has computed: what it takes of its own accord, whatever else the machine
/// does.
double computed() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

/// The longest time for which no event is handled while it lives: between two rounds of a timer that is
/// always due.
class HoldUp {
public:
    struct Longest {
        double milliseconds = 0;
        double computed = 0;
    };
    HoldUp() {
        m_since.start();
        QObject::connect(&m_timer, &QTimer::timeout, [this] { look(); });
        m_timer.start(0);
    }
    /// Since the last call.
    Longest take() {
        look();
        return std::exchange(m_longest, {});
    }

private:
    void look() {
        const double now = computed();
        m_longest.milliseconds =
            std::max(m_longest.milliseconds, static_cast<double>(m_since.nsecsElapsed()) * 1e-6);
        m_longest.computed = std::max(m_longest.computed, now - m_computed);
        m_computed = now;
        m_since.restart();
    }

    QTimer m_timer;
    QElapsedTimer m_since;
    double m_computed = computed();
    Longest m_longest;
};

void report(const char* when, const HoldUp::Longest& longest) {
    std::printf("%s, the window is held up for %.0f ms at most (computing: %.0f ms)\n", when,
                longest.milliseconds, longest.computed);
}

/// Whether the end of a line (0-based) is marked as wrong.
bool isMarked(const NcEditor& editor, int line) {
    constexpr unsigned long kErrorSquiggle = 8;
    const long end =
        editor.SendScintilla(QsciScintilla::SCI_GETLINEENDPOSITION, static_cast<unsigned long>(line));
    return editor.SendScintilla(QsciScintilla::SCI_INDICATORVALUEAT, kErrorSquiggle, end - 1) != 0;
}

/// Milliseconds from the wish to open a file.
struct Opening {
    double read = 0;
    double seen = 0;  ///< in the editor
    double first = 0; ///< motions
    double whole = 0; ///< and cut
};

Opening open(Session& session, const NcEditor& editor, const QString& file) {
    Opening opening;
    QElapsedTimer clock;
    clock.start();
    session.document().openFile(file);
    const auto note = [&](double& when, bool there) {
        if (there && when == 0)
            when = static_cast<double>(clock.nsecsElapsed()) * 1e-6;
        return when > 0;
    };
    until([&] { return note(opening.read, !session.document().isOpening()); }, kOpeningMs);
    if (session.document().text().path != file.toStdString())
        std::exit(EXIT_FAILURE);
    const auto all = [&] {
        const bool seen = note(opening.seen, !editor.isFilling());
        const bool first = note(opening.first, session.program().current() != nullptr);
        const bool whole = session.program().current() && !session.program().isReading() &&
                           session.simulation().frame() &&
                           session.simulation().frame()->program == session.program().current();
        return note(opening.whole, whole) && seen && first;
    };
    until(all, kOpeningMs);
    return opening;
}

void report(const char* what, std::vector<double> milliseconds) {
    std::ranges::sort(milliseconds);
    const auto percentile = [&](double share) {
        return milliseconds[static_cast<std::size_t>(share * static_cast<double>(milliseconds.size() - 1))];
    };
    std::printf("%s: %.0f ms, %.0f, %.0f (50th, 95th percentile, largest)\n", what, percentile(0.5),
                percentile(0.95), milliseconds.back());
}

} // namespace

int main(int argc, char** argv) {
    const QApplication application(argc, argv);
    const int keys = argc > 1 ? std::atoi(argv[1]) : 50;
    const QTemporaryDir folder;
    const bool named = argc > 2 && QFile::exists(QString::fromLocal8Bit(argv[2]));
    const int lines = argc > 2 && !named ? std::atoi(argv[2]) : 100'000;
    const QString file = named ? QString::fromLocal8Bit(argv[2]) : folder.filePath("long.nc");
    if (!named)
        writeProgram(file.toStdString(), lines);

    Session session;
    Appearance appearance;
    MainWindow window(session, appearance);
    window.resize(1280, 800);
    window.show();
    NcEditor& editor = window.editor().editor();
    HoldUp holdUp;
    // What the window has to do for any file, and once for the first one.
    for (const char* name : {"first.nc", "short.nc"}) {
        holdUp.take();
        writeProgram(folder.filePath(QLatin1String(name)).toStdString(), kShort);
        open(session, editor, folder.filePath(QLatin1String(name)));
    }
    report("while a short program is opened", holdUp.take());
    const Opening opening = open(session, editor, file);
    report("while the long one is opened", holdUp.take());
    std::printf("read after %.0f ms, seen after %.0f ms, first motions after %.0f ms, all after %.0f ms\n",
                opening.read, opening.seen, opening.first, opening.whole);

    if (named || session.document().text().readOnly)
        return EXIT_SUCCESS;

    std::mt19937 random(1);
    std::vector<double> marked;
    for (int i = 0; i < keys; ++i) {
        const int line = static_cast<int>(random() % static_cast<unsigned>(lines - 10)) + 4;
        editor.goTo(line + 1, 200);
        QTest::keyClick(&editor, Qt::Key_Question, Qt::ShiftModifier);
        marked.push_back(until([&] { return isMarked(editor, line); }));
        QTest::keyClick(&editor, Qt::Key_Backspace);
        // What is wrong is gone with its mark; the next key shall find nothing under way.
        until([&] { return session.program().current()->diagnostics().empty(); });
    }
    report("from a key to its squiggle", marked);
    return *std::ranges::max_element(marked) < kPatienceMs ? EXIT_SUCCESS : EXIT_FAILURE;
}
