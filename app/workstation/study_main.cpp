// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workstation/study_main.h"

#include <QBuffer>
#include <QImage>
#include <QPainter>
#include <QSvgRenderer>

#include "app/cli/run_command.h"
#include "app/cli/study_command.h"
#include "core/base/atomic_file.h"
#include "core/study/svg_chart.h"
#include "core/verification/findings/command_line_findings.h"
#include "ui/viewport/offscreen_drawing.h"

namespace proveout {

namespace {

constexpr int kPixelsAUnit = 2; ///< of the SVG

Result<void> writePicture(const std::filesystem::path& file, const std::string& svg) {
    QSvgRenderer renderer(QByteArray::fromStdString(svg));
    QImage image(kPixelsAUnit * kChartWidth, kPixelsAUnit * kChartHeight, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    renderer.render(&painter);
    painter.end();
    QBuffer bytes;
    if (!renderer.isValid() || !bytes.open(QIODevice::WriteOnly) || !image.save(&bytes, "PNG"))
        return failure(command_line_finding::kPictureFailed, {}, file.string());
    return writeFile(file, bytes.data().toStdString());
}

} // namespace

int studyMain(int argc, char** argv) {
    CLI::App app("Proves out three-axis milling programs before they touch metal.", "proveout");
    app.require_subcommand(1);
    cli::ExitCode exitCode = cli::ExitCode::done;
    const auto renderer = [](int width, int height) { return OffscreenDrawing::create(width, height); };
    cli::addStudyCommand(app, exitCode, {renderer, writePicture});
    return static_cast<int>(cli::runCommand(app, exitCode, argc, argv));
}

} // namespace proveout
