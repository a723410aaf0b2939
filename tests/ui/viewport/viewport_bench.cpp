// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's opening case: 500 x 500 mm at 1 mm, 500 000 triangles, played in a 3D view of 1280 x 800.
// Prints frames per second with and without decimation, and the cost of a frame.
//     viewport_bench [SECONDS]
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>

#include <QApplication>
#include <QElapsedTimer>
#include <QMainWindow>
#include <QTemporaryDir>

#include "ui/viewport/viewport.h"

using namespace proveout;

namespace {

constexpr double kSide = 500;
constexpr double kStepOver = 5;
constexpr double kStep = 5;
constexpr double kBlocksPerSecond = 500;

/// A wavy surface, milled along X row by row.
void writeProgram(const std::string& file) {
    std::ofstream out(file);
    out << "G21 G90 G17 T1 M6 S8000 M3 F3000\nG0 X0 Y0 Z10\n";
    bool forward = true;
    for (double y = 0; y <= kSide; y += kStepOver, forward = !forward)
        for (double along = 0; along <= kSide; along += kStep) {
            const double x = forward ? along : kSide - along;
            out << "G1 X" << x << " Y" << y << " Z" << -8 + 3 * std::sin(x / 40) * std::cos(y / 50) << "\n";
        }
    out << "G0 Z10\nM30\n";
}

void waitUntil(const std::function<bool()>& done, double seconds) {
    QElapsedTimer timer;
    timer.start();
    while (!done() && static_cast<double>(timer.elapsed()) < 1e3 * seconds)
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents | QEventLoop::AllEvents, 20);
}

void play(Session& session, Viewport& viewport, DecimationMethod method, double seconds) {
    DecimationParameters parameters;
    parameters.method = method;
    session.job().setParameters(parameters);
    session.playback().pause();
    session.playback().seek(0);
    waitUntil([&] { return session.simulation().block() == 0; }, 60);
    session.playback().setSpeed(kBlocksPerSecond);
    session.playback().play();
    waitUntil([&] { return session.simulation().block() > 500; }, 60);

    int pictures = 0;
    const auto counting = QObject::connect(&viewport, &QOpenGLWidget::frameSwapped, [&] { ++pictures; });
    const std::size_t firstBlock = session.simulation().block();
    const std::size_t firstRow = session.playback().frameStatistics().size();
    QElapsedTimer timer;
    timer.start();
    waitUntil([] { return false; }, seconds);
    const double elapsed = static_cast<double>(timer.nsecsElapsed()) * 1e-9;
    QObject::disconnect(counting);
    const std::size_t blocks = session.simulation().block() - firstBlock;
    session.playback().pause();

    double upload = 0;
    double draw = 0;
    const auto& rows = session.playback().frameStatistics();
    for (std::size_t row = firstRow; row < rows.size(); ++row) {
        upload += double{rows[row].uploadSeconds};
        draw += double{rows[row].drawSeconds};
    }
    const double count = std::max(1.0, static_cast<double>(rows.size() - firstRow));
    std::printf("%-18s %6.1f frames/s  upload %6.2f ms  draw %6.2f ms  %zu of %zu triangles  %.0f blocks/s\n",
                method == DecimationMethod::none ? "without decimation" : "with decimation",
                pictures / elapsed, 1e3 * upload / count, 1e3 * draw / count,
                session.simulation().frame()->surface.faces, session.simulation().frame()->surface.facesFull,
                static_cast<double>(blocks) / elapsed);
}

} // namespace

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    const double seconds = argc > 1 ? std::atof(argv[1]) : 8;
    const GlSupport support = probeGl();
    if (!support.usable) {
        std::printf("%s\n", qPrintable(support.reason));
        return 2;
    }
    std::printf("%s\n", qPrintable(support.renderer));
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("wavy.nc"));
    writeProgram(file.toStdString());

    Session session;
    QMainWindow window;
    auto* viewport = new Viewport(session, support, &window);
    viewport->setFixedSize(1280, 800);
    window.setCentralWidget(viewport);
    window.show();
    session.document().openFile(file);
    waitUntil([&] { return session.simulation().frame() != nullptr; }, 30);
    Setup setup = session.job().setup();
    setup.stock = {{0, 0, 0}, kSide, kSide, 40};
    setup.automaticGrid = false;
    setup.spacing = 1;
    setup.tools.set(1, parseCutter("ball:d=20,l=60").value());
    if (!session.job().setSetup(setup))
        return 3;
    waitUntil(
        [&] {
            return session.simulation().frame() != nullptr &&
                   session.simulation().frame()->zmap.grid().nx == 501;
        },
        60);
    play(session, *viewport, DecimationMethod::lee, seconds);
    play(session, *viewport, DecimationMethod::none, seconds);
    return 0;
}
