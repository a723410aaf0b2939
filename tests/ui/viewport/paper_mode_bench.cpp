// SPDX-License-Identifier: GPL-3.0-or-later
// The promise, measured: a job run block by block, each block cut, decimated where it is due, uploaded and
// drawn, with decimation and without. Both runs of a pair advance in turn, and take turns in going first, so
// that the machine's other work hits them alike. On every frame triangles drawn and bytes uploaded are
// compared; exits with 1 where decimation drew or uploaded more.
//     paper_mode_bench JOB [--size 1280x800] [--every N] [--pairs N] [--blocks N] [--grid MM]
#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <vector>

#include <QCommandLineParser>
#include <QElapsedTimer>
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>

#include "core/formats/job_file.h"
#include "core/nc/interpreter.h"
#include "core/simulation/simulation.h"
#include "ui/gl/scene_renderer.h"
#include "ui/viewport/camera.h"

using namespace proveout;

namespace {

constexpr int kTold = 10; ///< frames that break the promise are told up to here, then counted

double seconds(const QElapsedTimer& timer) {
    return static_cast<double>(timer.nsecsElapsed()) * 1e-9;
}

struct Options {
    int width = 1280;
    int height = 800;
    std::size_t every = 1;
    int pairs = 1;
    std::size_t blocks = 0; ///< 0: all
    double grid = 0;        ///< 0: the job's
};

struct FrameFigures {
    double simulate = 0; ///< seconds: cutting, decimation, bookkeeping
    double upload = 0;
    double draw = 0;
    std::size_t triangles = 0;
    std::size_t bytes = 0;

    [[nodiscard]] double total() const { return simulate + upload + draw; }
};

/// One of the two runs of a pair.
struct Run {
    std::unique_ptr<Simulation> simulation;
    std::unique_ptr<SceneRenderer> renderer;
    double waiting = 0; ///< seconds of blocks that were not drawn, for the next frame
    std::vector<FrameFigures> frames;

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
using Pair = std::array<Run, 2>; ///< with decimation, without

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
            return failure("no-renderer", "The driver refuses a shader.");
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

void print(const char* name, const std::vector<FrameFigures>& frames, int pairs) {
    FrameFigures sum;
    double triangles = 0;
    double bytes = 0;
    for (const FrameFigures& frame : frames) {
        sum.simulate += frame.simulate;
        sum.upload += frame.upload;
        sum.draw += frame.draw;
        triangles += static_cast<double>(frame.triangles);
        bytes += static_cast<double>(frame.bytes);
    }
    const auto count = static_cast<double>(frames.size());
    std::printf("%-20s %8.2f s a run = cutting and decimation %7.3f + upload %7.3f + drawing %8.2f   "
                "%8.0f triangles and %8.0f bytes a frame\n",
                name, sum.total() / pairs, sum.simulate / pairs, sum.upload / pairs, sum.draw / pairs,
                triangles / count, bytes / count);
}

double percentile(const std::vector<double>& sorted, int percent) {
    return sorted[(sorted.size() - 1) * static_cast<std::size_t>(percent) / 100];
}

std::vector<double> sortedTimes(const std::vector<FrameFigures>& frames) {
    std::vector<double> times;
    for (const FrameFigures& frame : frames)
        times.push_back(frame.total());
    std::ranges::sort(times);
    return times;
}

void printPercentiles(const std::vector<FrameFigures>& with, const std::vector<FrameFigures>& without) {
    const auto a = sortedTimes(with);
    const auto b = sortedTimes(without);
    for (const int percent : {50, 95, 99})
        std::printf("p%d of a frame        %8.3f ms / %8.3f ms = %6.3f\n", percent,
                    1e3 * percentile(a, percent), 1e3 * percentile(b, percent),
                    percentile(a, percent) / percentile(b, percent));
}

/// How many frames break "at most as many as without".
template<class Figure>
std::size_t compare(const char* name, const Pair& pair, const Options& options, Figure figure) {
    std::size_t broken = 0;
    double excess = 0;
    for (std::size_t k = 0; k < pair[0].frames.size(); ++k) {
        const std::size_t with = pair[0].frames[k].*figure;
        const std::size_t without = pair[1].frames[k].*figure;
        if (with <= without)
            continue;
        excess += static_cast<double>(with - without);
        if (++broken <= kTold)
            std::printf("block %zu: %zu %s with decimation, %zu without\n", k * options.every, with, name,
                        without);
    }
    std::printf("%s: more on %zu of %zu frames, %.0f in all\n", name, broken, pair[0].frames.size(), excess);
    return broken;
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
        if (number == 0) // the others have the same figures
            broken = compare("triangles", *pair, options, &FrameFigures::triangles) +
                     compare("bytes", *pair, options, &FrameFigures::bytes);
        for (std::size_t k = 0; k < frames.size(); ++k)
            frames[k].insert(frames[k].end(), (*pair)[k].frames.begin(), (*pair)[k].frames.end());
    }
    std::printf("%d pairs, %zu frames of %d x %d each\n", options.pairs,
                frames[0].size() / static_cast<std::size_t>(options.pairs), options.width, options.height);
    print("with decimation", frames[0], options.pairs);
    print("without", frames[1], options.pairs);
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
                       {"grid", "Another distance of the points; 0: the job's.", "MM", "0"}});
    parser.process(application);
    Options options;
    const QByteArray size = parser.value("size").toLatin1();
    if (parser.positionalArguments().size() != 1 ||
        std::sscanf(size.constData(), "%dx%d", &options.width, &options.height) != 2)
        parser.showHelp(3);
    options.every = std::max<std::size_t>(1, parser.value("every").toULongLong());
    options.pairs = std::max(1, parser.value("pairs").toInt());
    options.blocks = parser.value("blocks").toULongLong();
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
