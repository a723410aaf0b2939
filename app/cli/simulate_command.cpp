// SPDX-License-Identifier: GPL-3.0-or-later
// simulate: cuts a program and writes the requested files.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fmt/core.h>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/cli/box_output.h"
#include "app/cli/command.h"
#include "app/cli/final_surface.h"
#include "app/cli/load_program.h"
#include "app/cli/machine_report.h"
#include "app/cli/mesh_outputs.h"
#include "app/cli/outputs.h"
#include "app/cli/program_memory.h"
#include "app/cli/records_csv.h"
#include "app/cli/report.h"
#include "app/cli/run_json.h"
#include "app/cli/setup_options.h"
#include "app/cli/stop_block.h"
#include "app/cli/thread_limit.h"
#include "app/cli/tool_report.h"
#include "app/cli/zmap_file.h"
#include "core/base/memory.h"
#include "core/base/stop_watch.h"
#include "core/formats/stock_file.h"
#include "core/simulation/records/block_provenance.h"
#include "core/simulation/records/block_records.h"
#include "core/simulation/run/interpretation.h"
#include "core/simulation/run/simulation.h"
#include "core/simulation/run/walled_moment.h"
#include "core/simulation/setup/tool_choice.h"

namespace proveout::cli {

namespace {

struct SimulateOptions {
    SetupOptions setup;
    ThreadLimit threads;
    std::string until;
    std::string zmap;
    std::string provenance;
    MeshOutputs meshes;
    BoxOutput box;
    std::string mesh = "decimated";
    std::string rims = "on";
    std::string records;
    std::string stock;
    bool json = false;
};

/// Wall time of the phases, one after the other: together they are the total.
struct Seconds {
    double prepare = 0; ///< options, job, tools, stock file, checks
    double interpret = 0;
    double allocate = 0;
    double cut = 0;
    double rims = 0;
    double decimate = 0;
    double evaluate = 0; ///< findings, totals, machine times, the error of the surface
    double write = 0;
    double box = 0;
    double total = 0;
};

/// One run of the command; each part adds its errors to the report.
class SimulateRun {
public:
    explicit SimulateRun(SimulateOptions& options) : m_options(options), m_report(options.setup.subject()) {}

    ExitCode run() {
        if (!prepare() || !simulate())
            return failed();
        writeMaps();
        m_options.box.run(m_program, m_frame.setup, m_frame.block, m_report);
        m_seconds.box = lap();
        findRims();
        saveStock();
        if (!decimate() || !writeMeshes())
            return failed();
        m_seconds.total = m_lapped;
        if (m_options.json)
            printJson(object());
        else
            printSummary();
        return m_report.exitCode();
    }

private:
    template<class Value>
    bool fine(Result<Value>&& result) {
        if (!result && reportRest())
            m_report.addFatal(std::move(result.error()));
        return result.has_value();
    }

    /// Reports the messages of a program that is still being read, because those of its setup follow them.
    /// False if it turns out not to be a program.
    bool reportRest() {
        if (!m_reading || m_reading->isWhole())
            return true;
        while (!m_reading->isWhole())
            m_program = m_reading->next();
        return noteWhole(true);
    }

    ExitCode failed() {
        if (m_options.json)
            printJson({{"findings", m_report.findings()}, {"unverified", m_report.unverified()}});
        return m_report.exitCode();
    }

    /// The seconds since the previous lap.
    double lap() {
        const double now = m_watch.seconds();
        return now - std::exchange(m_lapped, now);
    }

    bool prepare() {
        auto job = m_options.setup.job();
        if (!job)
            return fine(std::move(job));
        m_job = std::move(*job);
        m_report.add(m_job.warnings);
        if (!fine(m_options.meshes.check()) || !fine(checkOutputs(inputs(), outputs())))
            return false;
        if (m_options.meshes.wanted() && m_options.mesh == "decimated" &&
            !fine(checkExportable(m_job.parameters)))
            return false;
        // A given grid is checked before a long program is read.
        const bool automatic = m_job.setup.automaticGrid;
        if ((!automatic && !checkGrid()) || !interpretProgram())
            return false;
        SetupOptions::settleGrid(m_job, *m_program, mapOutputs());
        const bool ready = (!automatic || checkGrid()) &&
                           (m_options.mesh == "full" ||
                            fine(m_options.meshes.checkRounding(m_job.parameters, m_job.setup.stock))) &&
                           fine(checkOutputs(inputs(), sizedOutputs()));
        m_seconds.prepare += lap();
        return ready;
    }

    [[nodiscard]] std::vector<std::string> inputs() const {
        std::vector<std::string> inputs = m_options.setup.inputs();
        inputs.push_back(m_job.program.string());
        return inputs;
    }

    [[nodiscard]] std::vector<Output> outputs() const { return allOutputs(m_options.meshes.outputs(), 0, 0); }

    /// Call it when program and grid are known.
    [[nodiscard]] std::vector<Output> sizedOutputs() const {
        const auto grid = makeGrid(m_job.setup.stock, m_job.setup.spacing);
        const bool full = m_options.mesh == "full" || writesFullMesh(m_job.parameters);
        return allOutputs(m_options.meshes.outputs(full ? &*grid : nullptr), heightsBytes(grid->nx, grid->ny),
                          kLeastRecordBytes * blocksToRun(parseStopBlock(m_options.until), *m_program));
    }

    [[nodiscard]] std::vector<Output> allOutputs(std::vector<Output> outputs, std::uint64_t mapBytes,
                                                 std::uint64_t recordBytes) const {
        outputs.insert(outputs.end(), {{m_options.zmap, mapBytes},
                                       {m_options.provenance, mapBytes},
                                       {m_options.records, recordBytes},
                                       {m_options.stock}});
        const std::vector<Output> box = m_options.box.outputs();
        outputs.insert(outputs.end(), box.begin(), box.end());
        return outputs;
    }

    bool checkGrid() {
        return fine(m_options.setup.checkGrid(m_job, mapOutputs())) &&
               fine(m_options.box.check(m_job.setup, hasRims(), heldBytes() + m_programMemory.held));
    }

    /// The memory of the z-map and its meshes that is still in use when the region is cut.
    [[nodiscard]] double heldBytes() const {
        const auto grid = makeGrid(m_job.setup.stock, m_job.setup.spacing);
        return grid ? zmapBytes(*grid) + static_cast<double>(grid->nx) * grid->ny *
                                             heldBytesPerPoint(scheduled(), mapOutputs())
                    : 0;
    }

    [[nodiscard]] double forecastBytes() const {
        return m_programMemory.with(
            std::max(mapBytes(m_frame.zmap.grid(), scheduled(), mapOutputs()),
                     m_options.box.wanted() ? heldBytes() + m_options.box.bytes() : 0));
    }

    [[nodiscard]] bool isShaped() const { return m_job.setup.shape.kind != StockKind::box; }

    [[nodiscard]] MapOutputs mapOutputs() const {
        const bool solid = m_options.meshes.wanted();
        const bool full = m_options.mesh == "full";
        return {.schedule = followsSchedule(),
                .shaped = isShaped(),
                .whole = !full && (solid || m_options.json),
                .solid = solid,
                .walls = hasWalls(),
                .again = !m_options.provenance.empty(),
                .watched = true};
    }

    bool interpretProgram() {
        m_seconds.prepare = lap();
        auto reading = startReading(m_job);
        if (!reading)
            return fine(std::move(reading));
        m_reading = std::move(*reading);
        do
            m_program = m_reading->next();
        while (!m_reading->isWhole() && !cutsWhileReading());
        m_seconds.interpret = lap();
        return !m_reading->isWhole() || noteWhole(false);
    }

    /// Once the program is whole: its memory, and its messages. False if it is not a program.
    bool noteWhole(bool isCutWhileRead) {
        m_programMemory = programMemory(*m_reading, *m_program, isCutWhileRead);
        return fine(reportProgram(*m_program, m_job, m_report));
    }

    /// Whether nothing before the end depends on what follows in the program, and there is memory for the map
    /// beside the program.
    [[nodiscard]] bool cutsWhileReading() const {
        if (m_job.setup.automaticGrid || followsSchedule() || !m_options.until.empty() ||
            ThreadLimit::threads() == 1)
            return false;
        const auto grid = makeGrid(m_job.setup.stock, m_job.setup.spacing);
        return grid && programMemory(*m_reading, *m_program, true)
                               .with(expectedMapBytes(*grid, scheduled(), mapOutputs())) <=
                           static_cast<double>(memoryLimitBytes());
    }

    /// Cuts a program of which only the beginning has been read, while the rest is.
    bool cutAsRead() {
        while (!m_reading->isWhole()) {
            m_simulation->seek(m_program->blockCount());
            const StopWatch waiting;
            m_program = m_reading->next();
            m_secondsWaited += waiting.seconds();
            (void)m_simulation->noteProgram(m_program);
            if (m_reading->isWhole() && !noteWhole(true))
                return false;
        }
        return true;
    }

    /// Intermediate surfaces are needed only for records or if a period was given: the outputs are decimated
    /// as a whole anyway.
    [[nodiscard]] bool followsSchedule() const {
        const bool given = m_options.setup.decimation().given("period") && m_job.parameters.period != 0;
        return !m_options.records.empty() || given;
    }

    /// The parameters of the surface during the simulation.
    [[nodiscard]] DecimationParameters scheduled() const {
        DecimationParameters parameters = m_job.parameters;
        if (!followsSchedule())
            parameters.period = 0;
        return parameters;
    }

    bool simulate() {
        auto simulation =
            Simulation::create(m_program, std::make_shared<const Setup>(m_job.setup), scheduled());
        if (!simulation)
            return fine(std::move(simulation));
        m_simulation = std::move(*simulation);
        m_simulation->setCheckpointBudget(0); // it only goes back to the uncut stock
        if (!m_options.json && !followsSchedule())
            m_simulation->keepRecordsOf({});
        if (!m_options.provenance.empty() || isShaped())
            m_uncut = m_simulation->zmap();
        if (!cutAsRead())
            return false;
        const std::size_t blocks = blocksToRun(parseStopBlock(m_options.until), *m_program);
        if (followsSchedule())
            m_simulation->play(blocks);
        else
            m_simulation->seek(blocks);
        m_frame = m_simulation->frame();
        Diagnostics findings = m_frame.findings;
        for (Diagnostic& finding : findings)
            if (finding.file.empty()) // otherwise it concerns the stock file
                finding.file = m_job.program.string();
        m_report.add(std::move(findings));
        m_times = machineTimes(m_program, m_job.machine.value_or(Machine()));
        if (m_options.json)
            m_totals = totalsOf(*m_program, m_frame.statistics, m_frame.block);
        const Simulation::Effort effort = m_simulation->effort();
        m_seconds.allocate = effort.allocateSeconds;
        m_seconds.cut = effort.cutSeconds;
        m_seconds.decimate = effort.decimationSeconds;
        m_seconds.interpret += m_secondsWaited;
        m_seconds.evaluate =
            lap() - m_seconds.allocate - m_seconds.cut - m_seconds.decimate - m_secondsWaited;
        return true;
    }

    /// The other methods are those of the paper, and need a plain z-map.
    [[nodiscard]] bool hasWalls() const {
        const bool certified = m_job.parameters.method == DecimationMethod::certified;
        return hasRims() && (certified || m_options.mesh == "full");
    }
    [[nodiscard]] bool hasRims() const { return m_options.rims == "on"; }

    void findRims() {
        if (hasWalls())
            addWalls(m_frame, isShaped() ? &m_uncut : nullptr);
        m_seconds.rims = lap();
    }

    /// Makes the surface if an output needs it; false if there is not enough memory for it.
    bool decimate() {
        if (!m_options.json && !m_options.meshes.wanted())
            return true;
        const bool made = m_surface.make(*m_simulation, m_frame.zmap, order(), m_report);
        m_seconds.decimate += m_surface.decimationSeconds();
        m_seconds.evaluate += lap() - m_surface.decimationSeconds();
        return made;
    }

    [[nodiscard]] FinalSurface::Order order() const {
        return {.job = m_job,
                .scheduled = scheduled(),
                .outputs = mapOutputs(),
                .forecastBytes = forecastBytes(),
                .coordinates = m_options.meshes.coordinates(),
                .decimated = m_options.mesh == "decimated",
                .measured = m_options.json};
    }

    /// The files that need no surface, so that they are written even if there is not enough memory for one.
    void writeMaps() {
        if (!m_options.zmap.empty())
            fine(writeZMap(m_options.zmap, m_frame.zmap));
        if (!m_options.provenance.empty())
            fine(writeProvenance(m_options.provenance, m_frame.zmap.grid(),
                                 *blockProvenance(m_uncut, *m_program, m_job.setup, m_frame.block),
                                 *m_program));
        if (!m_options.records.empty())
            fine(writeRecords(m_options.records, m_frame));
        m_seconds.write = lap();
    }

    /// With its rims, but before the surface is made.
    void saveStock() {
        if (!m_options.stock.empty())
            fine(writeStock(m_options.stock, m_frame.zmap, m_job.setup.spacing, provenance()));
        m_seconds.write += lap();
    }

    /// False if there is not enough memory for the solid.
    bool writeMeshes() {
        if (!m_options.meshes.wanted())
            return true;
        const double before = m_surface.decimationSeconds();
        const bool complete = m_surface.write(m_options.meshes, m_frame.zmap, order(), m_report);
        const double again = m_surface.decimationSeconds() - before;
        m_seconds.decimate += again;
        m_seconds.write += lap() - again;
        return complete;
    }

    [[nodiscard]] nlohmann::ordered_json object() const {
        const Grid& grid = m_frame.zmap.grid();
        nlohmann::ordered_json out{
            {"program", m_job.program.string()},
            {"blocks", m_program->sourceBlockCount()},
            {"motions", executedMotions()},
            {"movingBlocks", m_frame.block},
            {"movingBlocksInProgram", m_program->blockCount()},
            {"finished", m_frame.block == m_program->blockCount()},
            {"grid",
             {{"nx", grid.nx},
              {"ny", grid.ny},
              {"hx", grid.hx},
              {"hy", grid.hy},
              {"spacing", m_job.setup.spacing},
              {"automatic", m_job.setup.automaticGrid}}},
            {"startTool", startToolAsJson(*m_program, m_job.setup)},
            {"tools", toolsAsJson(m_job.setup.tools)},
            {"removedMm3", m_frame.removedMm3},
            {"machineSeconds",
             machineSeconds(*m_times, m_frame.block, !m_job.machine, ToolChoice(*m_program, m_job.setup))},
            {"facesFull", m_surface.surface().facesFull},
            {"facesDecimated", m_surface.surface().faces},
            {"largestErrorMm", largestErrorMm(m_surface.measured().largestErrorMm, m_surface.written(),
                                              m_job.parameters.allowance)},
            {"errorLevel", m_surface.measured().level},
            {"regions", m_surface.surface().grid.regionCount()},
            {"method", kMethodChoices[static_cast<std::size_t>(m_job.parameters.method)].key},
            {"mesh", m_options.mesh},
            {"seconds",
             {{"prepare", m_seconds.prepare},
              {"interpret", m_seconds.interpret},
              {"allocate", m_seconds.allocate},
              {"cut", m_seconds.cut},
              {"rims", m_seconds.rims},
              {"decimate", m_seconds.decimate},
              {"evaluate", m_seconds.evaluate},
              {"write", m_seconds.write},
              {"box", m_seconds.box},
              {"total", m_seconds.total}}},
            {"secondsBeside", {{"interpret", m_reading->seconds()}}},
            {"threads", ThreadLimit::threads()},
            {"cpuSeconds", static_cast<double>(std::clock()) / CLOCKS_PER_SEC},
            {"expectedBytes",
             std::llround(m_programMemory.with(expectedMapBytes(grid, scheduled(), mapOutputs())))},
            {"forecastBytes", std::llround(forecastBytes())},
            {"peakBytes", peakMemoryBytes()}};
        if (hasWalls()) {
            const RimMap& rims = m_frame.zmap.rims();
            out["rims"] = countOf(rims);
            out["rimTilesUnknown"] = unknownTiles(rims);
            out["ribsUnseen"] = unseenRibs(rims);
        }
        out["records"] = totalsAsJson(m_totals, *m_program, m_frame.setup);
        m_options.meshes.addTo(out, m_surface.written());
        if (m_options.box.wanted())
            out["box"] = m_options.box.object();
        out["ignoredCodes"] = ignoredCodesAsJson(*m_program);
        out["findings"] = m_report.findings();
        out["unverified"] = m_report.unverified();
        return out;
    }

    [[nodiscard]] StockProvenance provenance() const {
        const bool cut = m_frame.block > 0;
        return {.program = m_job.program.filename().string(),
                .blocks = m_frame.block,
                .line = cut ? m_program->blockLine(m_frame.block - 1) : 0,
                .finished = m_frame.block == m_program->blockCount()};
    }

    [[nodiscard]] std::size_t executedMotions() const {
        return m_frame.block == 0 ? 0 : m_program->blockMotions(m_frame.block - 1).last;
    }

    void printSummary() const {
        fmt::print("{} of {} motion blocks, {:.1f} mm³ removed, {:.3f} s; {} on {} machine\n", m_frame.block,
                   m_program->blockCount(), m_frame.removedMm3, m_seconds.total,
                   clockText(m_times->secondsAfter[m_frame.block]), m_job.machine ? "the" : "the default");
        const Grid& grid = m_frame.zmap.grid();
        if (m_job.setup.automaticGrid)
            fmt::print("grid: {:g} mm (automatic), {} × {} points\n", m_job.setup.spacing, grid.nx, grid.ny);
        if (const std::size_t ribs = unseenRibs(m_frame.zmap.rims()); ribs > 0)
            fmt::print("ribs thinner than the grid: between its points in {} places\n", ribs);
        printTools(m_job.setup.tools, true);
        printFiles(m_surface.written());
        m_options.box.print();
    }

    SimulateOptions& m_options;
    const StopWatch m_watch;
    FinalSurface m_surface; ///< if JSON or a mesh file was requested
    Report m_report;
    Job m_job;
    std::unique_ptr<ProgramReading> m_reading;
    ProgramMemory m_programMemory;            ///< once all of it has been read
    std::shared_ptr<const Program> m_program; ///< its beginning, until all of it has been read
    std::unique_ptr<Simulation> m_simulation;
    Frame m_frame;
    ZMapSnapshot m_uncut; ///< if provenance was requested, and of stock that is not a box
    std::shared_ptr<const MachineTimes> m_times;
    RunTotals m_totals; ///< if JSON was requested
    Seconds m_seconds;
    double m_secondsWaited = 0; ///< for the program, while it was cut
    double m_lapped = 0;        ///< seconds after which the present phase began
};

} // namespace

void addSimulateCommand(CLI::App& app, ExitCode& exitCode) {
    auto* command = app.add_subcommand("simulate", "Simulate a program and write the requested outputs");
    auto options = std::make_shared<SimulateOptions>();
    options->setup.addTo(*command);
    options->threads.addTo(*command);
    command->add_option("--until", options->until, "Stop after motion block N (from 1), or after line n")
        ->type_name("N|L<n>")
        ->check([](const std::string& text) {
            return parseStopBlock(text) ? std::string() : "\"" + text + "\" is not a block N or a line L<n>";
        });
    command->add_option("--zmap", options->zmap, "Write the z-map (NPY)")->type_name("F.npy");
    command
        ->add_option("--provenance", options->provenance,
                     "Write the program line that cut each point last (NPY of uint32, 0: uncut); cuts again, "
                     "and needs 13 bytes per point")
        ->type_name("F.npy");
    options->meshes.addTo(*command);
    command->add_option("--mesh", options->mesh, "Surface of the exported solid (decimated)")
        ->check(CLI::IsMember({"decimated", "full"}))
        ->type_name("M");
    options->box.addTo(*command);
    command
        ->add_option("--rims", options->rims, "Put walls of meshes where they stand, not at grid points (on)")
        ->check(CLI::IsMember({"on", "off"}))
        ->type_name("on|off");
    command->add_option("--records", options->records, "Write one row per motion block (CSV)")
        ->type_name("F.csv");
    command
        ->add_option("--save-stock", options->stock,
                     "Write the remaining stock for the next setup (--stock file:file=…)")
        ->type_name("F.pvstock");
    command->add_flag("--json", options->json, "Print one JSON object");
    command->callback([options, &exitCode] {
        options->threads.apply();
        exitCode = SimulateRun(*options).run();
    });
}

} // namespace proveout::cli
