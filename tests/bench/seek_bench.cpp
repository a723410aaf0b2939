// SPDX-License-Identifier: GPL-3.0-or-later
// seek_bench [SPACING [WORKLOAD [SEEKS [MEGABYTES]]]]: what a user waits for on the timeline of a long
// program, for cutting only: seeks to random blocks and single steps back after a complete run, within a
// memory limit for checkpoints (by default the product's); then the cost of an edit in the last tenth as a
// share of the first run, and a detail region in the middle.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "core/base/stop_watch.h"
#include "core/decimation/surface/refined_surface.h"
#include "core/nc/run/interpreter.h"
#include "core/simulation/records/box_of_interest.h"
#include "core/simulation/run/simulation.h"
#include "tests/bench/workloads.h"

namespace proveout::bench {
namespace {

std::shared_ptr<const Setup> setupOf(const Workload& workload, double spacing) {
    auto setup = std::make_shared<Setup>();
    setup->stock = stockOf(workload);
    setup->spacing = spacing;
    setup->tools.set(1, parseCutter(fmt::format("ball:d={}", workload.diameter)).value());
    return setup;
}

class Waits {
public:
    void add(double seconds) { m_seconds.push_back(seconds); }
    /// The time in milliseconds that the given share of all samples does not exceed.
    [[nodiscard]] double at(double part) {
        std::ranges::sort(m_seconds);
        const double last = static_cast<double>(m_seconds.size() - 1);
        return 1000 * m_seconds[static_cast<std::size_t>(last * part)];
    }

private:
    std::vector<double> m_seconds;
};

/// Duplicates a line in the middle of the last tenth of the blocks.
std::shared_ptr<const Program> editedProgram(const std::string& text, const Program& program) {
    std::size_t at = 0;
    for (std::uint32_t line = program.blockLine(program.blockCount() * 95 / 100); line > 1; --line)
        at = text.find('\n', at) + 1;
    std::string edited = text;
    edited.insert(at, "G91 G1 X0.01\nG90\n");
    return interpret(NcText(edited));
}

void measureEdit(Simulation& simulation, const std::string& text, double cutSeconds) {
    const auto edited = editedProgram(text, simulation.program());
    simulation.seek(simulation.blockCount()); // moving to the end is not part of the edit
    const std::size_t before = simulation.effort().blocksCut;
    const double secondsBefore = simulation.effort().cutSeconds;
    simulation.seek(simulation.noteProgram(edited));
    simulation.seek(simulation.blockCount());
    const auto cut = static_cast<double>(simulation.effort().blocksCut - before);
    std::puts(
        fmt::format("        an edit in the last tenth cuts {:.1f} % of the blocks, in {:.1f} % of the time",
                    100 * cut / static_cast<double>(simulation.blockCount()),
                    100 * (simulation.effort().cutSeconds - secondsBefore) / cutSeconds)
            .c_str());
}

/// 20 × 20 mm at 0.01 mm: 4 million points.
void measureBox(const Program& program, const Setup& setup) {
    const Vec2 middle = Vec2(setup.stock.corner) + Vec2(setup.stock.width, setup.stock.depth) / 2.0;
    const BoxOfInterest box{{middle - 10.0, middle + 10.0}, 0.01};
    const GridPart part = fineGrid(setup, box, fineParameters(box.spacing), {}, 4e9).value();
    const FineMap fine = *cutBox(program, setup, program.blockCount(), part);
    const StopWatch decimation;
    const std::size_t faces = decimatedWhole(fine.zmap, fineParameters(box.spacing)).faces;
    std::puts(fmt::format(
                  "        a box of {} x {} points, near {} motions, is cut in {:.2f} s and decimated to {} "
                  "triangles in {:.2f} s",
                  part.nx, part.ny, fine.motions, fine.seconds, faces, decimation.seconds())
                  .c_str());
}

void measure(const Workload& workload, double spacing, int seeks, std::size_t budget) {
    const std::string source = programOf(workload);
    const NcText text(source);
    DecimationParameters parameters;
    parameters.period = 0;
    const StopWatch run;
    const auto setup = setupOf(workload, spacing);
    const auto simulation = std::move(Simulation::create(interpret(text), setup, parameters).value());
    simulation->setCheckpointBudget(budget);
    simulation->seek(simulation->blockCount());
    const double runSeconds = run.seconds();
    const double cutSeconds = simulation->effort().cutSeconds;
    std::mt19937 random(1);
    Waits sought;
    Waits steppedBack;
    for (int k = 0; k < seeks; ++k) {
        const StopWatch seek;
        simulation->seek(random() % (simulation->blockCount() + 1));
        sought.add(seek.seconds());
        const StopWatch back;
        simulation->seek(std::max<std::size_t>(simulation->position(), 1) - 1);
        steppedBack.add(back.seconds());
    }
    std::puts(fmt::format("{:<8}{:>9}{:>9.1f}{:>8}{:>10.1f}{:>10.1f}{:>10.1f}{:>10.1f}{:>10.1f}",
                          workload.name, simulation->blockCount(), runSeconds, seeks, sought.at(0.5),
                          sought.at(0.99), sought.at(1), steppedBack.at(0.5), steppedBack.at(1))
                  .c_str());
    measureBox(simulation->program(), *setup);
    measureEdit(*simulation, source, cutSeconds);
    std::fflush(stdout);
}

} // namespace
} // namespace proveout::bench

int main(int argc, char** argv) {
    using namespace proveout::bench;
    const double spacing = argc > 1 ? std::strtod(argv[1], nullptr) : 0.5;
    const std::string only = argc > 2 ? argv[2] : "";
    const int seeks = argc > 3 ? std::max(1, std::atoi(argv[3])) : 500;
    const auto budget = static_cast<std::size_t>(1e6 * (argc > 4 ? std::strtod(argv[4], nullptr) : 1000));
    std::puts(fmt::format("at {} mm: seconds of the first run with its interpretation; then milliseconds of "
                          "seeks and of steps back\n{:<8}{:>9}{:>9}{:>8}{:>10}{:>10}{:>10}{:>10}{:>10}",
                          spacing, "", "blocks", "run", "seeks", "half", "99 %", "largest", "back", "largest")
                  .c_str());
    for (const Workload& workload : workloads()) {
        if (only.empty() || only == workload.name)
            measure(workload, spacing, seeks, budget);
    }
    return 0;
}
