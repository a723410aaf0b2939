// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the guarantee: runs a job block by block, where each block is cut, decimated when due, uploaded
// and drawn, with and without decimation. Both runs of a pair advance alternately, and alternate in which one
// is first, so that other load on the machine affects both equally. Compares the triangles drawn and bytes
// uploaded in every frame; exits with 1 if decimation drew or uploaded more.
//     paper_mode_bench JOB [--size 1280x800] [--every N] [--pairs N] [--blocks N] [--grid MM] [--hold-back]
#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <optional>
#include <vector>

#include <QCommandLineParser>
#include <QElapsedTimer>
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>

#include "core/formats/job_file.h"
#include "core/nc/run/interpreter.h"
#include "core/simulation/run/simulation.h"
#include "core/simulation/thread/hold_back.h"
#include "core/verification/findings/window_findings.h"
#include "tests/ui/viewport/frame_figures.h"
#include "ui/gl/scene_renderer.h"
#include "ui/viewport/camera.h"

using namespace proveout;

namespace {

double seconds(const QElapsedTimer& timer) {
    return static_cast<double>(timer.nsecsElapsed()) * 1e-9;
}

struct Options {
    int width = 1280;
    int height = 800;
    std::size_t every = 1;
    int pairs = 1;
    std::size_t blocks = 0; ///< 0: all
    double grid = 0;        ///< 0: that of the job
    bool holdBack = false;  ///< as playback does in the window; otherwise decimation always runs
};

/// One of the two runs of a pair.
struct Run {
    std::unique_ptr<Simulation> simulation;
    std::unique_ptr<SceneRenderer> renderer;
    double waiting = 0; ///< seconds of blocks that were not drawn, added to the next frame
    std::vector<FrameFigures> frames;
    std::optional<HoldBack> holdBack;
    DecimationParameters wanted;

    /// Sets the parameters that are decided after the last shown frame.
    void follow() {
        DecimationParameters played = wanted;
        if (holdBack->held())
            played.method = DecimationMethod::none;
        simulation->noteParameters(played);
        simulation->seek(simulation->position());
    }

    void weigh(const Frame& frame, const FrameFigures& figures) {
        const BlockStatistics row = frame.statistics[frame.block - 1];
        const FrameCost cost{row.decimationSeconds,
                             figures.upload,
                             figures.draw,
                             frame.surface.faces,
                             frame.surface.facesFull,
                             row.regionsDecimated,
                             frame.surface.grid.regionCount()};
        QElapsedTimer timer;
        timer.start();
        if (holdBack->add(cost))
            follow();
        waiting = seconds(timer);
    }

    void show(const View& view, const QElapsedTimer& simulated) {
        FrameFigures figures;
        QElapsedTimer timer;
        const auto frame = std::make_shared<const Frame>(simulation->frame());
        figures.simulate = waiting + seconds(simulated);
        waiting = 0;
        timer.start();
        figures.bytes = renderer->upload(frame).bytes;
        renderer->finish();
        figures.upload = seconds(timer);
        timer.restart();
        renderer->draw(view, {});
        renderer->finish();
        figures.draw = seconds(timer);
        figures.triangles = renderer->triangles(SurfaceBuffer::Part::fromZMap) +
                            renderer->triangles(SurfaceBuffer::Part::decimated);
        frames.push_back(figures);
        if (holdBack && frame->block > 0)
            weigh(*frame, figures);
    }

    void step(const View& view, bool drawn) {
        QElapsedTimer timer;
        timer.start();
        simulation->step();
        if (drawn)
            show(view, timer);
        else
            waiting += seconds(timer);
    }
};
using Pair = std::array<Run, 2>; ///< with and without decimation

struct Workload {
    std::shared_ptr<const Program> program;
    std::shared_ptr<const Setup> setup;
    std::array<DecimationParameters, 2> parameters;
    View view;
};

View viewOf(const StockBox& stock, int width, int height) {
    Box3 box;
    box.add(stock.corner);
    box.add(Vec3(stock.corner.x + stock.width, stock.corner.y + stock.depth, stock.floorZ()));
    Camera camera;
    camera.setPicture(width, height, 1);
    camera.setStandardView(StandardView::iso);
    camera.fit(box);
    return camera.view(box);
}

Result<Workload> load(const QString& file, const Options& options) {
    auto job = readJob(file.toStdString());
    if (!job)
        return tl::unexpected(job.error());
    const auto text = NcText::load(job->program);
    if (!text)
        return tl::unexpected(text.error());
    if (options.grid > 0)
        job->setup.spacing = options.grid;
    Workload workload{interpret(*text),
                      std::make_shared<const Setup>(job->setup),
                      {job->parameters, job->parameters},
                      viewOf(job->setup.stock, options.width, options.height)};
    workload.parameters[1].method = DecimationMethod::none;
    return workload;
}

Result<Pair> runPair(const Workload& workload, const Options& options, std::size_t number) {
    Pair runs;
    for (std::size_t turn = 0; turn < runs.size(); ++turn) {
        const std::size_t k = (turn + number) % runs.size();
        QElapsedTimer timer;
        timer.start();
        auto created = Simulation::create(workload.program, workload.setup, workload.parameters[k]);
        if (!created)
            return tl::unexpected(created.error());
        runs[k].simulation = std::move(*created);
        runs[k].renderer = SceneRenderer::create();
        if (!runs[k].renderer)
            return failure(window_finding::kOpenGlMissing);
        runs[k].wanted = workload.parameters[k];
        if (options.holdBack && k == 0) {
            runs[k].holdBack.emplace(runs[k].wanted.period, runs[k].simulation->frame().surface.facesFull);
            runs[k].follow();
        }
        runs[k].show(workload.view, timer);
    }
    const std::size_t all = workload.program->blockCount();
    const std::size_t blocks = options.blocks == 0 ? all : std::min(options.blocks, all);
    for (std::size_t block = 1; block <= blocks; ++block)
        for (std::size_t turn = 0; turn < runs.size(); ++turn)
            runs[(turn + block + number) % runs.size()].step(workload.view, block % options.every == 0);
    for (Run& run : runs) {
        run.renderer->release();
        run.simulation.reset();
    }
    return runs;
}

int bench(const QString& file, const Options& options) {
    const auto workload = load(file, options);
    if (!workload) {
        std::fprintf(stderr, "%s\n", oneLine(workload.error().front()).c_str());
        return 3;
    }
    std::array<std::vector<FrameFigures>, 2> frames;
    std::size_t broken = 0;
    for (int number = 0; number < options.pairs; ++number) {
        const auto pair = runPair(*workload, options, static_cast<std::size_t>(number));
        if (!pair) {
            std::fprintf(stderr, "%s\n", oneLine(pair.error().front()).c_str());
            return 3;
        }
        if (number == 0) // the others have the same values
            broken =
                compare("triangles", (*pair)[0].frames, (*pair)[1].frames, options.every,
                        &FrameFigures::triangles) +
                compare("bytes", (*pair)[0].frames, (*pair)[1].frames, options.every, &FrameFigures::bytes);
        for (std::size_t k = 0; k < frames.size(); ++k)
            frames[k].insert(frames[k].end(), (*pair)[k].frames.begin(), (*pair)[k].frames.end());
    }
    std::printf("%d pairs, %zu frames of %d x %d each\n", options.pairs,
                frames[0].size() / static_cast<std::size_t>(options.pairs), options.width, options.height);
    printSums("with decimation", frames[0], options.pairs);
    printSums("without", frames[1], options.pairs);
    printPercentiles(frames[0], frames[1]);
    return broken == 0 ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
    const QGuiApplication application(argc, argv);
    QCommandLineParser parser;
    parser.addHelpOption();
    parser.addPositionalArgument("JOB", "A .proveout file.");
    parser.addOptions({{"size", "Pixels of the picture.", "WxH", "1280x800"},
                       {"every", "Draw only each N-th block.", "N", "1"},
                       {"pairs", "Pairs of runs.", "N", "1"},
                       {"blocks", "Stop after so many blocks; 0: at the end.", "N", "0"},
                       {"grid", "Another distance of the points; 0: the job's.", "MM", "0"},
                       {"hold-back", "Decide as playback does whether to decimate."}});
    parser.process(application);
    Options options;
    const QByteArray size = parser.value("size").toLatin1();
    if (parser.positionalArguments().size() != 1 ||
        std::sscanf(size.constData(), "%dx%d", &options.width, &options.height) != 2)
        parser.showHelp(3);
    options.every = std::max<std::size_t>(1, parser.value("every").toULongLong());
    options.pairs = std::max(1, parser.value("pairs").toInt());
    options.blocks = parser.value("blocks").toULongLong();
    options.holdBack = parser.isSet("hold-back");
    options.grid = parser.value("grid").toDouble();

    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    QOffscreenSurface surface;
    surface.setFormat(format);
    surface.create();
    QOpenGLContext context;
    context.setFormat(format);
    if (!context.create() || !context.makeCurrent(&surface)) {
        std::fprintf(stderr, "OpenGL 3.3 is not to be had here.\n");
        return 2;
    }
    QOpenGLFramebufferObject target(options.width, options.height, QOpenGLFramebufferObject::Depth);
    target.bind();
    return bench(parser.positionalArguments().front(), options);
}
