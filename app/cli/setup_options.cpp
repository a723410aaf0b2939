// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/setup_options.h"

#include <set>
#include <string_view>
#include <utility>

#include "app/cli/option_error.h"
#include "core/base/memory.h"
#include "core/cutter/tool_file.h"
#include "core/formats/stock_shapes.h"

namespace proveout::cli {

namespace {

const std::string kGuessed = "auto";

} // namespace

void StockOptions::addTo(CLI::App& command) {
    command
        .add_option("--stock", spec,
                    "Stock: a box, or a shape, e.g. cylinder:d=50,h=20; shapes: proveout-cli stocks")
        ->type_name("WxDxH|SHAPE:key=value,…");
    command.add_option("--stock-origin", origin, "Lower-left-top corner of the stock, mm (0,0,0)")
        ->type_name("X,Y,Z");
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
    // A box of another size stays where the job has it.
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
                "--tool",
                failure("tool-twice", "Tool {} is given twice.", {std::to_string(tool->first)}).value());
        table.set(tool->first, std::move(tool->second));
    }
    return {};
}

void CompensationStart::addTo(CLI::App& command) {
    command
        .add_option("--compensation-start", type,
                    "How cutter compensation of Fanuc and Haas begins and ends at outside corners: type a "
                    "straight, type b round them (a)")
        ->check(CLI::IsMember(std::vector<std::string>{"a", "b"}))
        ->type_name("T");
}

void CompensationStart::apply(bool& typeB) const {
    if (!type.empty())
        typeB = type == "b";
}

Diagnostics unusedCompensationStart(bool typeB, const Program& program) {
    const Dialect& row = dialect(program.dialect());
    if (!typeB || row.vectors.used)
        return {};
    Diagnostics told =
        failure("compensation-start-unused",
                "Type B of the start of cutter compensation changes nothing: {} knows no types.", {row.name})
            .value();
    told.front().severity = Severity::warning;
    return told;
}

void SetupOptions::addTo(CLI::App& command) {
    command.add_option("PROG", m_program, "NC program")->type_name("");
    command.add_option("--job", m_jobFile, "Job file with program, stock, grid, tools and decimation")
        ->type_name("FILE");
    m_stock.addTo(command);
    command.add_option("--grid", m_grid, "Grid spacing, mm (1)")->type_name("H");
    m_tools.addTo(command);
    command.add_option("--start", m_start, "Position before the first block, mm (not known)")
        ->type_name("X,Y,Z");
    command.add_flag("--block-delete", m_blockDelete, "Skip blocks that begin with /");
    m_compensationStart.addTo(command);
    addDialectOption(command, m_dialect);
    command
        .add_option("--machine", m_machine,
                    "How fast the machine is, e.g. rapidXY=20000,largestFeed=10000,accelerationXY=2000; also "
                    "rapidZ, accelerationZ, cornerDeviation, toolChange (mm, minutes; seconds)")
        ->type_name("key=value,…");
    m_decimation.addTo(command);
}

Result<Job> SetupOptions::job() const {
    Job job;
    if (!m_jobFile.empty()) {
        auto read = readJob(m_jobFile);
        if (!read)
            return tl::unexpected(std::move(read.error()));
        job = std::move(*read);
    }
    if (!m_program.empty())
        job.program = m_program;
    if (job.program.empty())
        return failure("no-program", "No program is given: name one, or a --job.", {}, "proveout-cli");
    if (m_jobFile.empty() && m_stock.spec.empty())
        return failure("no-stock", "No stock is given: use --stock WxDxH, or a --job.", {}, "proveout-cli");
    if (auto stock = m_stock.apply(job.setup); !stock)
        return tl::unexpected(std::move(stock.error()));
    if (m_grid)
        job.setup.spacing = *m_grid;
    if (auto tools = m_tools.apply(job.setup.tools); !tools)
        return tl::unexpected(std::move(tools.error()));
    if (!m_start.empty()) {
        auto start = parsePoint(m_start);
        if (!start)
            return aboutOption("--start", std::move(start.error()));
        job.setup.start = *start;
    }
    if (!m_dialect.empty())
        job.setup.dialect = dialectOfOption(m_dialect);
    job.setup.blockDelete = job.setup.blockDelete || m_blockDelete;
    m_compensationStart.apply(job.setup.compensationTypeB);
    if (!m_machine.empty()) {
        auto machine = parseMachine(m_machine, job.machine.value_or(Machine()));
        if (!machine)
            return aboutOption("--machine", std::move(machine.error()));
        job.machine = *machine;
    }
    const bool fromFile = !m_jobFile.empty();
    m_decimation.apply(job.parameters, {.region = job.regionNamed, .period = fromFile},
                       gridPoints(job.setup.stock, job.setup.spacing));
    return job;
}

Result<void> SetupOptions::checkGrid(const Job& job, const MapOutputs& outputs) const {
    const auto grid = makeGrid(job.setup.stock, job.setup.spacing);
    if (!grid)
        return aboutGrid(grid.error());
    const auto limit = static_cast<double>(memoryLimitBytes());
    if (auto fits = checkMapMemory(job.setup.stock, *grid, job.parameters, outputs, limit); !fits)
        return aboutGrid(std::move(fits.error()));
    return {};
}

/// The job file is meant where its value was used.
tl::unexpected<Diagnostics> SetupOptions::aboutGrid(Diagnostics diagnostics) const {
    const std::string_view id = diagnostics.front().id;
    const bool origin = id.starts_with("stock-origin");
    const bool size = id.starts_with("stock-size");
    const bool given = origin ? !m_stock.origin.empty() : size ? !m_stock.spec.empty() : m_grid.has_value();
    if (given || m_jobFile.empty())
        return aboutOption(origin ? "--stock-origin" : size ? "--stock" : "--grid", std::move(diagnostics));
    for (Diagnostic& diagnostic : diagnostics)
        diagnostic.file = m_jobFile;
    return tl::unexpected(std::move(diagnostics));
}

std::optional<DialectId> dialectOfOption(const std::string& key) {
    const Dialect* row = findDialect(key);
    return row == nullptr ? std::nullopt : std::optional(row->id);
}

std::set<std::string> dialectKeys() {
    std::set<std::string> keys;
    for (const Dialect& row : dialects())
        keys.emplace(row.key);
    return keys;
}

void addDialectOption(CLI::App& command, std::string& key) {
    std::set<std::string> keys = dialectKeys();
    keys.insert(kGuessed);
    command.add_option("--dialect", key, "Dialect of the program (auto: by its signs)")
        ->check(CLI::IsMember(std::move(keys)))
        ->type_name("D");
}

} // namespace proveout::cli
