// SPDX-License-Identifier: GPL-3.0-or-later
// From a key to its squiggle: the workstation with a program of 100 000 lines, something wrong typed at the
// end of random ones. Prints how long opening takes, and percentiles in milliseconds. A program that is shown
// read-only is only opened.
//     typing_bench [KEYS] [LINES]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <random>
#include <vector>

#include <QApplication>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>

#include "ui/appearance.h"
#include "ui/editor/editor_panel.h"
#include "ui/editor/nc_editor.h"
#include "ui/main_window.h"

using namespace proveout;

namespace {

constexpr double kPatienceMs = 60'000;

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
double until(const std::function<bool()>& done) {
    QElapsedTimer timer;
    timer.start();
    const auto elapsed = [&] { return static_cast<double>(timer.nsecsElapsed()) * 1e-6; };
    while (!done() && elapsed() < kPatienceMs)
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents | QEventLoop::AllEvents, 1);
    return elapsed();
}

/// Whether the end of a line (0-based) is marked as wrong.
bool isMarked(const NcEditor& editor, int line) {
    constexpr unsigned long kErrorSquiggle = 8;
    const long end =
        editor.SendScintilla(QsciScintilla::SCI_GETLINEENDPOSITION, static_cast<unsigned long>(line));
    return editor.SendScintilla(QsciScintilla::SCI_INDICATORVALUEAT, kErrorSquiggle, end - 1) != 0;
}

void tell(const char* what, std::vector<double> milliseconds) {
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
    const int lines = argc > 2 ? std::atoi(argv[2]) : 100'000;
    const QTemporaryDir folder;
    const QString file = folder.filePath("long.nc");
    writeProgram(file.toStdString(), lines);

    Session session;
    Appearance appearance;
    MainWindow window(session, appearance);
    window.resize(1280, 800);
    window.show();
    QElapsedTimer opening;
    opening.start();
    if (!session.openFile(file))
        return EXIT_FAILURE;
    const double held = static_cast<double>(opening.nsecsElapsed()) * 1e-6;
    const double first = held + until([&] { return session.program() != nullptr; });
    const double whole = first + until([&] {
                             return session.program() && !session.isReading() && session.frame() &&
                                    session.frame()->program == session.program();
                         });
    std::printf(
        "opening: the window is held up for %.0f ms; first motions after %.0f ms, all after %.0f ms\n", held,
        first, whole);
    NcEditor& editor = window.editor().editor();

    if (session.document().readOnly)
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
        until([&] { return session.program()->diagnostics().empty(); });
    }
    tell("from a key to its squiggle", marked);
    return *std::ranges::max_element(marked) < kPatienceMs ? EXIT_SUCCESS : EXIT_FAILURE;
}
