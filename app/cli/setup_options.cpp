// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/setup_options.h"

#include <set>
#include <utility>
#include <variant>

#include "app/cli/option_error.h"
#include "core/base/memory.h"
#include "core/cutter/tool_file.h"
#include "core/decimation/regions/region_decimator.h"
#include "core/formats/fixture_file.h"
#include "core/formats/job_findings.h"
#include "core/formats/job_paths.h"
#include "core/formats/stock_shapes.h"
#include "core/nc/codes/dialects.h"
#include "core/simulation/setup/automatic_grid.h"
#include "core/simulation/setup/machine_profiles.h"
#include "core/simulation/setup/setup_fields.h"
#include "core/verification/findings/command_line_findings.h"
#include "core/zmap/zmap_findings.h"

namespace proveout::cli {

void StockOptions::addTo(CLI::App& command) {
    command
        .add_option("--stock", spec,
                    "Stock: a box, or a shape, e.g. cylinder:d=50,h=20; shapes: proveout-cli stocks")
        ->type_name("WxDxH|SHAPE:key=value,…");
    command
        .add_option("--stock-origin", origin,
                    "Min X, min Y and top Z of the stock, mm (0,0,0: its top is at Z0)")
        ->type_name("MINX,MINY,TOPZ");
}

Result<void> StockOptions::apply(Setup& setup) const {
    std::optional<Vec3> corner;
    if (!origin.empty()) {
        const auto point = parsePoint(origin);
        if (!point)
            return aboutOption("--stock-origin", point.error());
        corner = *point;
        setup.stock.corner = *point;
    }
    if (spec.empty())
        return {};
    auto stock = parseStock(spec);
    if (!stock)
        return aboutOption("--stock", std::move(stock.error()));
    // A box of another size keeps the position in the job.
    if (stock->shape.kind == StockKind::box)
        corner = setup.stock.corner;
    if (auto made = makeStock(*stock, corner); !made)
        return tl::unexpected(std::move(made.error()));
    setup.stock = stock->box;
    setup.shape = std::move(stock->shape);
    if (setup.shape.body)
        setup.spacing = setup.shape.body->spacing().value_or(setup.spacing);
    return {};
}

std::string StockOptions::file() const {
    const auto stock = parseStock(spec);
    return stock ? stock->shape.file.string() : std::string();
}

void ToolOptions::addTo(CLI::App& command) {
    command
        .add_option("--tool", tools,
                    "A tool, e.g. 1=ball:d=11,l=50; repeatable; shapes: proveout-cli tools --shapes")
        ->type_name("N=SHAPE:key=value,…")
        ->allow_extra_args(false);
    command.add_option("--tools", file, "Tool table (TOML)")->type_name("FILE");
}

Result<void> ToolOptions::apply(ToolTable& table) const {
    if (!file.empty()) {
        auto read = readToolFile(file);
        if (!read)
            return tl::unexpected(std::move(read.error()));
        for (const auto& [number, cutter] : read->tools())
            table.set(number, cutter);
    }
    std::set<int> named;
    for (const auto& option : tools) {
        auto tool = parseToolOption(option);
        if (!tool)
            return aboutOption("--tool", std::move(tool.error()));
        if (!named.insert(tool->first).second)
            return aboutOption(
                "--tool", failure(command_line_finding::kToolTwice, {std::to_string(tool->first)}).value());
        table.set(tool->first, std::move(tool->second));
    }
    return {};
}

void FixtureOptions::addTo(CLI::App& command) {
    command
        .add_option("--fixture", fixtures,
                    "What holds the stock, e.g. jaw=box:x=-20,y=0,z=-30,w=20,d=80,h=25 or "
                    "screw=cylinder:x=9,y=9,z=0,d=12,h=8 (mm, x and y of the corner or the axis, z of the "
                    "bottom) or vice=stl:x=0,y=0,z=-30,turn=90,scale=1,file=vice.stl; repeatable")
        ->type_name("NAME=SHAPE:key=value,…")
        ->allow_extra_args(false);
}

Result<void> FixtureOptions::apply(Fixtures& into) const {
    for (const std::string& option : fixtures) {
        auto fixture = parseFixtureOption(option);
        if (!fixture)
            return aboutOption("--fixture", std::move(fixture.error()));
        if (auto* mesh = std::get_if<FixtureMesh>(&fixture->second)) {
            mesh->file = absolutePath(mesh->file);
            readFixtureFile(*mesh);
        }
        into[fixture->first] = fixture->second;
    }
    return {};
}

void PartOptions::addTo(CLI::App& command) {
    command
        .add_option("--part", part,
                    "The design part (STL, program coordinates) to compare the stock with at the end; its "
                    "zero elsewhere: x=10,y=5,z=-20,turn=90,scale=25.4,allowance=0.3,file=part.stl")
        ->type_name("FILE");
    command
        .add_option(
            "--tolerance", tolerance,
            "How much may be missing of the part, and left on it, normal to its surface, mm (0.1,0.1)")
        ->type_name("BELOW[,ABOVE]");
}

Result<void> PartOptions::apply(std::optional<PartSpec>& into) const {
    if (!part.empty()) {
        auto read = parsePart(part, into.value_or(PartSpec()));
        if (!read)
            return aboutOption("--part", std::move(read.error()));
        read->file = absolutePath(read->file);
        into = std::move(*read);
    }
    if (tolerance.empty())
        return {};
    if (!into)
        return aboutOption("--tolerance", failure(command_line_finding::kNoPart).value());
    auto read = parseTolerance(tolerance, into->tolerance);
    if (!read)
        return aboutOption("--tolerance", std::move(read.error()));
    into->tolerance = *read;
    return {};
}

Diagnostics unusedCompensationStart(bool typeB, const Program& program) {
    const Dialect& row = dialect(program.dialect());
    if (!typeB || row.vectors.used)
        return {};
    return {diagnosticOf(command_line_finding::kCompensationStartUnused, {row.name})};
}

void SetupOptions::addTo(CLI::App& command) {
    command.add_option("PROG", m_program, "NC program")->type_name("");
    command.add_option("--job", m_jobFile, "Job file with program, stock, grid, tools and decimation")
        ->type_name("FILE");
    addSharedTo(command);
    m_decimation.addTo(command);
}

void SetupOptions::addSharedTo(CLI::App& command) {
    command.add_flag("--allow-outside", m_allowOutside, "Allow the job to read files outside its folder");
    m_stock.addTo(command);
    const Setup nothing;
    describeGrid(nothing, OptionAdder{command, m_given});
    m_tools.addTo(command);
    m_fixtures.addTo(command);
    describeControl(nothing, OptionAdder{command, m_given});
    command
        .add_option("--machine", m_machine,
                    "Machine values, e.g. vmc-760,largestFeed=10000; profiles: " + machineProfileKeys() +
                        "; keys: " + keysWithUnits<Machine>())
        ->type_name("PROFILE,key=value,…");
}

Result<Job> SetupOptions::readJobFile() const {
    auto job = m_allowOutside ? readJob(m_jobFile, anyOutside) : readJob(m_jobFile);
    if (!job)
        for (Diagnostic& error : job.error())
            if (hasIdOf(error, job_finding::kJobOutside))
                error.text = command_line_finding::kJobOutside.text;
    return job;
}

Result<Job> SetupOptions::job() const {
    if (m_program.empty() && m_jobFile.empty())
        return failure(command_line_finding::kNoProgram, {}, "proveout-cli");
    if (!stockGiven())
        return failure(command_line_finding::kNoStock, {}, "proveout-cli");
    return givenJob();
}

Result<Job> SetupOptions::jobOf(const std::string& file, bool isJobFile) const {
    SetupOptions one = *this;
    (isJobFile ? one.m_jobFile : one.m_program) = file;
    return one.givenJob();
}

Result<Job> SetupOptions::givenJob() const {
    Job job;
    if (!m_jobFile.empty()) {
        auto read = readJobFile();
        if (!read)
            return tl::unexpected(std::move(read.error()));
        job = std::move(*read);
    }
    if (!m_program.empty())
        job.program = m_program;
    if (job.program.empty())
        return failure(command_line_finding::kNoProgram, {}, "proveout-cli");
    if (auto stock = m_stock.apply(job.setup); !stock)
        return tl::unexpected(std::move(stock.error()));
    job.setup.automaticGrid = job.setup.automaticGrid || m_jobFile.empty();
    if (auto tools = m_tools.apply(job.setup.tools); !tools)
        return tl::unexpected(std::move(tools.error()));
    if (auto fixtures = m_fixtures.apply(job.setup.fixtures); !fixtures)
        return tl::unexpected(std::move(fixtures.error()));
    Result<void> given;
    describe(job.setup, OptionReader{m_given, given});
    if (!given)
        return tl::unexpected(std::move(given.error()));
    if (!m_machine.empty()) {
        auto machine = parseMachine(m_machine, job.machine.value_or(Machine()));
        if (!machine)
            return aboutOption("--machine", std::move(machine.error()));
        job.machine = *machine;
    }
    const bool fromFile = !m_jobFile.empty();
    const DecimationMethod before = job.parameters.method;
    m_decimation.apply(job.parameters, {.region = job.regionNamed, .period = fromFile},
                       gridPoints(job.setup.stock, job.setup.spacing));
    job.regionNamed = m_decimation.given("region") || (job.regionNamed && job.parameters.method == before);
    return job;
}

void SetupOptions::settleGrid(Job& job, const Program& program, const MapOutputs& outputs) {
    if (!job.setup.automaticGrid)
        return;
    job.setup.spacing = gridSpacing(job.setup, program, gridLimits(job.parameters, outputs));
    if (!job.regionNamed)
        job.parameters.regionCells =
            defaultRegion(job.parameters.method, gridPoints(job.setup.stock, job.setup.spacing));
}

Result<void> SetupOptions::checkGrid(const Job& job, const MapOutputs& outputs) const {
    if (auto whole = checkShape(job.setup.shape); !whole)
        return whole;
    const auto grid = makeGrid(job.setup.stock, job.setup.spacing);
    if (!grid)
        return aboutGrid(grid.error());
    const auto limit = static_cast<double>(memoryLimitBytes());
    if (auto fits = checkMapMemory(job.setup.stock, *grid, job.parameters, outputs, limit); !fits)
        return aboutGrid(std::move(fits.error()));
    return {};
}

/// The message refers to the job file if its value was used.
tl::unexpected<Diagnostics> SetupOptions::aboutGrid(Diagnostics diagnostics) const {
    const Diagnostic& reason = diagnostics.front();
    const bool origin = hasIdOf(reason, zmap_finding::kStockOriginBad);
    const bool size =
        hasIdOf(reason, zmap_finding::kStockSizeBad) || hasIdOf(reason, zmap_finding::kStockSizeNarrow);
    const bool given = origin ? !m_stock.origin.empty()
                       : size ? !m_stock.spec.empty()
                              : m_given.contains(setup_field::kGrid.key);
    if (given || m_jobFile.empty())
        return aboutOption(origin ? "--stock-origin" : size ? "--stock" : "--grid", std::move(diagnostics));
    for (Diagnostic& diagnostic : diagnostics)
        diagnostic.file = m_jobFile;
    return tl::unexpected(std::move(diagnostics));
}

} // namespace proveout::cli
