// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/mutation_kinds.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <streambuf>

#include "app/cli/setup_options.h"
#include "app/cli/zmap_file.h"
#include "core/base/memory.h"
#include "core/cutter/tool_file.h"
#include "core/decimation/surface/refined_surface.h"
#include "core/formats/job_file.h"
#include "core/formats/nc_motion.h"
#include "core/formats/stock_file.h"
#include "core/formats/stock_shapes.h"
#include "core/formats/zip_file.h"
#include "core/nc/codes/dialects.h"
#include "core/nc/run/interpreter.h"
#include "core/simulation/setup/automatic_grid.h"
#include "core/simulation/setup/tool_proposals.h"
#include "tests/fuzz/nc_words.h"

namespace proveout::test {

namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

/// Points of the grids of these runs: few, because there are many runs. The time for finer grids follows from
/// their number of points, which the program checks before.
constexpr GridLimits kGrid{1e4, 4e4};

std::string bytesOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Discards what is written.
class Nowhere : public std::streambuf {
protected:
    int_type overflow(int_type c) override { return traits_type::not_eof(c); }
    std::streamsize xsputn(const char* /*text*/, std::streamsize count) override { return count; }
};

/// The length of the text selects the dialect, so that the file alone reproduces a run.
std::optional<DialectId> dialectFor(const NcText& text) {
    const std::size_t choice = text.size() % (dialects().size() + 1);
    return choice < dialects().size() ? std::optional(dialects()[choice].id) : std::nullopt;
}

bool runProgram(const fs::path& file) {
    const auto text = NcText::load(file);
    if (!text)
        return false;
    static_cast<void>(proposeTools(*text));
    InterpretOptions options;
    options.file = file.string();
    options.dialect = dialectFor(*text);
    options.subprogramFolders = {file.parent_path()};
    const auto program = interpret(*text, options);
    Nowhere nowhere;
    std::ostream out(&nowhere);
    writeNcMotion(out, *program, *text, {});
    return program->motionCount() > 0;
}

/// Creates the uncut z-map of a stock from a file, like a run of the command line.
bool runStock(const std::string& text) {
    auto spec = parseStock(text);
    if (!spec || !makeStock(*spec, {}))
        return false;
    const double spacing = spec->shape.body->spacing().value_or(automaticSpacing(spec->box, {}, kGrid));
    const auto grid = makeGrid(spec->box, spacing);
    if (!grid || !checkMemory(spec->box, *grid, static_cast<double>(memoryLimitBytes())))
        return false;
    static_cast<void>(uncutStock(spec->box, spec->shape, *grid));
    return true;
}

bool runStl(const fs::path& file) {
    return runStock("stl:file=" + file.string());
}

bool runOutline(const fs::path& file) {
    return runStock("outline:h=12,file=" + file.string());
}

bool runSavedStock(const fs::path& file) {
    return runStock("file:flip=x,turn=90,file=" + file.string());
}

/// With valid checksums, which a damaged archive does not have.
bool runStockDescription(const fs::path& file) {
    const fs::path archive = file.parent_path() / "described.pvstock";
    ZipFile zip(archive, false);
    zip.beginEntry("stock.json");
    zip.write(bytesOf(file));
    zip.beginEntry("heights.npy");
    zip.write(stockHeights());
    return zip.commit() && runSavedStock(archive);
}

bool runJob(const fs::path& file) {
    const auto job = readJob(file);
    return job && jobText(file, *job);
}

bool runToolTable(const fs::path& file) {
    return readToolFile(file).has_value();
}

/// Like `decimate`.
bool runNpy(const fs::path& file) {
    const DecimationParameters parameters;
    const auto zmap = cli::readZMap(file, 0.5, {0, 0}, {}, [&](const StockBox& stock, const Grid& grid) {
        return checkMapMemory(stock, grid, parameters, {.whole = true},
                              static_cast<double>(memoryLimitBytes()));
    });
    return zmap && decimatedWhole(*zmap, parameters).faces > 0;
}

/// Parses the options of a run and reads its program. Options that write files are not included.
bool runOptions(const fs::path& file) {
    std::vector<std::string> arguments;
    std::ifstream lines(file, std::ios::binary);
    for (std::string line; std::getline(lines, line);)
        arguments.push_back(std::move(line));
    std::ranges::reverse(arguments); // in the sequence that the parser expects
    CLI::App app;
    cli::SetupOptions options;
    options.addTo(app);
    try {
        app.parse(arguments);
    } catch (const CLI::Error&) {
        return false;
    }
    auto job = options.job();
    if (!job)
        return false;
    cli::SetupOptions::settleGrid(*job, *interpret(NcText("")), {});
    return options.checkGrid(*job, {}).has_value();
}

Words noWords() {
    return {};
}

Words stlWords() {
    return {"solid ",    "facet normal 0 0 1\n", "outer loop\n", "vertex 0 0 0\n",
            "endloop\n", "endfacet\n",           "endsolid\n",   "\xef\xbb\xbf"};
}

Words jsonWords() {
    return {"null",        "true",
            "[[[[[[[[",    "{\"a\":{\"b\":",
            "\"stock\":",  "\"shape\":\"stl\",\"file\":\"seed.stl\"",
            "\"\\u0000\"", "1e400",
            "-1",          "\"tools\":{\"0\":\"flat:d=1\"}",
            "\xff"};
}

Words tomlWords() {
    return {"[[tool]]\n",
            "[tool]\n",
            "number = 0\n",
            "number = 99999999999\n",
            "cutter = \"ball:d=nan\"\n",
            "\"\"\"",
            "'''",
            "{a={b={c=1}}}",
            "1979-05-27T07:32:00Z",
            "0x7fffffffffffffff",
            ",r=-1",
            ",l=0",
            "flat:d=1e308",
            "#"};
}

Words optionWords() {
    return {"\n--stock\n",
            "\n--grid\n",
            "\n--tool\n",
            "\n--job\n",
            "\n--help\n",
            "\n--\n",
            "=",
            "1e-9",
            "stl:file=seed.stl",
            "file:file=seed.pvstock",
            "outline:file=a.csv,h=1",
            "box:w=1,d=1,h=1"};
}

constexpr std::array kKinds{
    MutationKind{"program", ".nc", programSeeds, ncWords, runProgram},
    MutationKind{"stl", ".stl", stlSeeds, stlWords, runStl},
    MutationKind{"job", ".proveout", jobSeeds, jsonWords, runJob},
    MutationKind{"tool-table", ".toml", toolTableSeeds, tomlWords, runToolTable},
    MutationKind{"outline", ".csv", outlineSeeds, noWords, runOutline},
    MutationKind{"saved-stock", ".pvstock", savedStockSeeds, noWords, runSavedStock},
    MutationKind{"stock-description", ".json", stockDescriptionSeeds, jsonWords, runStockDescription},
    MutationKind{"npy", ".npy", npySeeds, noWords, runNpy},
    MutationKind{"options", ".txt", optionSeeds, optionWords, runOptions},
};

} // namespace

std::span<const MutationKind> mutationKinds() {
    return kKinds;
}

} // namespace proveout::test
