// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/setup_options.h"

#include <charconv>
#include <fmt/format.h>
#include <set>
#include <system_error>
#include <utility>

#include "app/cli/option_error.h"
#include "core/base/memory.h"
#include "core/cutter/tool_file.h"
#include "core/decimation/regions/region_decimator.h"
#include "core/formats/job_findings.h"
#include "core/formats/stock_shapes.h"
#include "core/nc/codes/dialects.h"
#include "core/nc/codes/ignored_codes.h"
#include "core/simulation/setup/automatic_grid.h"
#include "core/simulation/setup/setup_fields.h"
#include "core/verification/findings/command_line_findings.h"
#include "core/zmap/zmap_findings.h"

namespace proveout::cli {

namespace {

const std::string kGuessed = "auto";
const std::string kAutomatic = "auto"; ///< of the grid

std::optional<double> numberOf(const std::string& text) {
    double number = 0;
    const char* const end = text.data() + text.size();
    const auto [read, error] = std::from_chars(text.data(), end, number);
    return error == std::errc{} && read == end ? std::optional(number) : std::nullopt;
}

std::string checkSpacingText(const std::string& text) {
    if (text == kAutomatic || numberOf(text))
        return {};
    return fmt::format("{} is neither a number of mm nor \"{}\"", text, kAutomatic);
}

} // namespace

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
                "--tool", failure(command_line_finding::kToolTwice, {std::to_string(tool->first)}).value());
        table.set(tool->first, std::move(tool->second));
    }
    return {};
}

void StartOptions::addTo(CLI::App& command, const std::string& withoutPosition) {
    const Field& start = setup_field::kStartTool;
    command.add_option("--start", position, "Position before the first block, mm (" + withoutPosition + ")")
        ->type_name("X,Y,Z");
    command.add_option("--start-tool", tool, std::string(start.help) + " (unknown)")
        ->check(CLI::Range(static_cast<int>(start.minimum), static_cast<int>(start.maximum)))
        ->type_name("N");
}

Result<void> StartOptions::apply(Setup& setup) const {
    if (tool)
        setup.startTool = tool;
    if (position.empty())
        return {};
    auto start = parsePoint(position);
    if (!start)
        return aboutOption("--start", std::move(start.error()));
    const Field& field = setup_field::kStart;
    for (int axis = 0; axis < 3; ++axis) {
        if ((*start)[axis] < field.minimum || (*start)[axis] > field.maximum)
            return aboutOption(
                "--start", failure(command_line_finding::kStartOutOfRange,
                                   {std::string(1, "XYZ"[axis]), fmt::format("{:g}", (*start)[axis]),
                                    fmt::format("{:g}", field.minimum), fmt::format("{:g}", field.maximum)})
                               .value());
    }
    setup.start = *start;
    return {};
}

void CompensationStart::addTo(CLI::App& command) {
    command
        .add_option("--compensation-start", type,
                    "Start-up and cancel of Fanuc and Haas cutter compensation at outside corners: type a "
                    "straight, type b round them (a)")
        ->check(CLI::IsMember(std::vector<std::string>{"a", "b"}))
        ->type_name("T");
}

void CompensationStart::apply(bool& typeB) const {
    if (!type.empty())
        typeB = type == "b";
}

void IgnoredMOption::addTo(CLI::App& command) {
    command
        .add_option("--ignore-m", list,
                    "M codes that move no axis on this machine (clamps, doors, air), e.g. 16,24,25; they are "
                    "ignored and listed")
        ->type_name("N,…");
}

Result<void> IgnoredMOption::apply(std::set<int>& codes) const {
    auto read = parseMCodes(list);
    if (!read)
        return aboutOption("--ignore-m", std::move(read.error()));
    codes.merge(*read);
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
    command.add_flag("--allow-outside", m_allowOutside, "Allow the job to read files outside its folder");
    m_stock.addTo(command);
    command
        .add_option(
            "--grid", m_grid,
            "Grid spacing, mm (auto: one tenth of the smallest cutter diameter, 1 to 4 million points)")
        ->check(checkSpacingText)
        ->type_name("H|auto");
    m_tools.addTo(command);
    m_start.addTo(command, "unknown");
    command.add_flag("--block-delete", m_blockDelete, "Block delete: skip blocks that start with /");
    m_compensationStart.addTo(command);
    m_ignoredM.addTo(command);
    addDialectOption(command, m_dialect);
    command
        .add_option("--machine", m_machine,
                    "Machine speeds, e.g. rapidXY=20000,largestFeed=10000,accelerationXY=2000; also rapidZ, "
                    "accelerationZ, cornerDeviation, toolChange (mm/min, mm/s², mm, s)")
        ->type_name("key=value,…");
    m_decimation.addTo(command);
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
    if (m_jobFile.empty() && m_stock.spec.empty())
        return failure(command_line_finding::kNoStock, {}, "proveout-cli");
    if (auto stock = m_stock.apply(job.setup); !stock)
        return tl::unexpected(std::move(stock.error()));
    if (m_jobFile.empty() || m_grid == kAutomatic)
        job.setup.automaticGrid = true;
    if (const auto spacing = numberOf(m_grid)) {
        job.setup.automaticGrid = false;
        job.setup.spacing = *spacing;
    }
    if (auto tools = m_tools.apply(job.setup.tools); !tools)
        return tl::unexpected(std::move(tools.error()));
    if (auto start = m_start.apply(job.setup); !start)
        return tl::unexpected(std::move(start.error()));
    if (!m_dialect.empty())
        job.setup.dialect = dialectOfOption(m_dialect);
    job.setup.blockDelete = job.setup.blockDelete || m_blockDelete;
    m_compensationStart.apply(job.setup.compensationTypeB);
    if (auto ignored = m_ignoredM.apply(job.setup.ignoredM); !ignored)
        return tl::unexpected(std::move(ignored.error()));
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
            standardRegion(job.parameters.method, gridPoints(job.setup.stock, job.setup.spacing));
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

/// The job file is meant where its value was used.
tl::unexpected<Diagnostics> SetupOptions::aboutGrid(Diagnostics diagnostics) const {
    const Diagnostic& reason = diagnostics.front();
    const bool origin = hasIdOf(reason, zmap_finding::kStockOriginBad);
    const bool size =
        hasIdOf(reason, zmap_finding::kStockSizeBad) || hasIdOf(reason, zmap_finding::kStockSizeNarrow);
    const bool given = origin ? !m_stock.origin.empty() : size ? !m_stock.spec.empty() : !m_grid.empty();
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
    command.add_option("--dialect", key, "Dialect of the program (auto: detected from the program)")
        ->check(CLI::IsMember(std::move(keys)))
        ->type_name("D");
}

} // namespace proveout::cli
