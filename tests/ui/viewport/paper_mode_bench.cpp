// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's promise, measured: a job run block by block, each block cut, decimated where it is due,
// uploaded and drawn, with decimation and without. Both runs advance in turn, so that the machine's other
// work hits them alike.
//     paper_mode_bench JOB [WIDTHxHEIGHT] [EVERY]      EVERY: draw only each EVERY-th block
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>

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

double seconds(const QElapsedTimer& timer) {
    return static_cast<double>(timer.nsecsElapsed()) * 1e-9;
}

/// One of the two runs, and what it has cost so far.
struct Run {
    std::unique_ptr<Simulation> simulation;
    std::unique_ptr<SceneRenderer> renderer;
    double simulate = 0; ///< seconds: cutting, decimation, bookkeeping
    double upload = 0;
    double draw = 0;
    double faces = 0; ///< sum over the frames drawn

    void step(const View& view, bool drawn) {
        QElapsedTimer timer;
        timer.start();
        simulation->step();
        if (!drawn) {
            simulate += seconds(timer);
            return;
        }
        const auto frame = std::make_shared<const Frame>(simulation->frame());
        simulate += seconds(timer);
        timer.restart();
        renderer->upload(frame);
        renderer->finish();
        upload += seconds(timer);
        timer.restart();
        renderer->draw(view, {});
        renderer->finish();
        draw += seconds(timer);
        faces += static_cast<double>(frame->surface.faces);
    }
};

void print(const char* name, const Run& run, int frames) {
    std::printf("%-20s %8.2f s  = cutting and decimation %7.3f + upload %7.3f + drawing %8.2f   %8.0f "
                "triangles a frame\n",
                name, run.simulate + run.upload + run.draw, run.simulate, run.upload, run.draw,
                run.faces / std::max(1, frames));
}

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

int bench(const char* jobFile, int width, int height, int every) {
    const auto job = readJob(jobFile);
    const auto text = job ? NcText::load(job->program) : Result<NcText>(tl::unexpected(job.error()));
    if (!text) {
        std::fprintf(stderr, "%s\n", oneLine(text.error().front()).c_str());
        return 3;
    }
    const auto program = interpret(*text);
    const auto setup = std::make_shared<const Setup>(job->setup);
    const View view = viewOf(setup->stock, width, height);

    std::array<Run, 2> runs;
    std::array<DecimationParameters, 2> parameters{job->parameters, job->parameters};
    parameters[1].method = DecimationMethod::none;
    for (std::size_t k = 0; k < runs.size(); ++k) {
        QElapsedTimer timer;
        timer.start();
        auto created = Simulation::create(program, setup, parameters[k]);
        runs[k].simulate = seconds(timer);
        runs[k].renderer = SceneRenderer::create();
        if (!created || !runs[k].renderer)
            return 3;
        runs[k].simulation = std::move(*created);
    }
    int frames = 0;
    for (std::size_t block = 0; block < program->blockCount(); ++block) {
        const bool drawn = block % static_cast<std::size_t>(every) == 0;
        frames += drawn ? 1 : 0;
        // The two take turns in going first.
        for (std::size_t turn = 0; turn < runs.size(); ++turn)
            runs[(turn + block) % runs.size()].step(view, drawn);
    }
    std::printf("%zu blocks, %d frames of %d x %d\n", program->blockCount(), frames, width, height);
    print("with decimation", runs[0], frames);
    print("without", runs[1], frames);
    const auto total = [](const Run& run) { return run.simulate + run.upload + run.draw; };
    std::printf("with / without       %8.3f\n", total(runs[0]) / total(runs[1]));
    for (Run& run : runs)
        run.renderer->release();
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    const QGuiApplication application(argc, argv);
    int width = 1280;
    int height = 800;
    if (argc < 2 || (argc > 2 && std::sscanf(argv[2], "%dx%d", &width, &height) != 2)) {
        std::fprintf(stderr, "usage: paper_mode_bench JOB [WIDTHxHEIGHT] [EVERY]\n");
        return 3;
    }
    const int every = std::max(1, argc > 3 ? std::atoi(argv[3]) : 1);
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
    QOpenGLFramebufferObject target(width, height, QOpenGLFramebufferObject::Depth);
    target.bind();
    return bench(argv[1], width, height, every);
}
