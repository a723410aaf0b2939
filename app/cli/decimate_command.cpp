// SPDX-License-Identifier: GPL-3.0-or-later
// decimate: decimates a given z-map, without a simulation.
#include <cmath>
#include <fmt/core.h>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/decimation_options.h"
#include "app/cli/measured_surface.h"
#include "app/cli/mesh_outputs.h"
#include "app/cli/option_error.h"
#include "app/cli/outputs.h"
#include "app/cli/report.h"
#include "app/cli/thread_limit.h"
#include "app/cli/zmap_file.h"
#include "core/base/memory.h"
#include "core/base/stop_watch.h"
#include "core/decimation/surface/map_memory.h"
#include "core/decimation/surface/refined_surface.h"
#include "core/verification/findings/command_line_findings.h"

namespace proveout::cli {

namespace {

struct DecimateOptions {
    std::string zmap;
    double spacing = 0;
    std::string origin = "0,0";
    std::optional<double> floor;
    DecimationOptions decimation;
    ThreadLimit threads;
    MeshOutputs meshes;
    bool json = false;
};

MapOutputs mapOutputs(const DecimateOptions& options) {
    return {.schedule = false, .whole = true, .solid = options.meshes.wanted()};
}

/// The z-map, once everything that can be refused without decimating has been checked, and its parameters.
Result<ZMapSnapshot> prepare(const DecimateOptions& options, DecimationParameters& parameters) {
    const bool solid = options.meshes.wanted();
    if (auto known = options.meshes.check(); !known)
        return tl::unexpected(std::move(known.error()));
    if (auto writable = checkOutputs({options.zmap}, options.meshes.outputs()); !writable)
        return tl::unexpected(std::move(writable.error()));
    if (auto crackFree = checkExportable(parameters); solid && !crackFree)
        return tl::unexpected(std::move(crackFree.error()));
    const auto origin = parsePoint(options.origin + ",0");
    if (!origin)
        return aboutOption("--origin", failure(command_line_finding::kPointForm, {options.origin}).value());
    return readZMap(options.zmap, options.spacing, Vec2(*origin), options.floor,
                    [&](const StockBox& stock, const Grid& grid) {
                        options.decimation.apply(parameters, {}, static_cast<double>(grid.nx) * grid.ny);
                        if (solid)
                            parameters.regionCells = forExport(parameters).regionCells;
                        if (auto rounding = options.meshes.checkRounding(parameters, stock); !rounding)
                            return rounding;
                        const Grid* full = writesFullMesh(parameters) ? &grid : nullptr;
                        if (auto space = checkOutputs({options.zmap}, options.meshes.outputs(full)); !space)
                            return space;
                        return checkMapMemory(stock, grid, parameters, mapOutputs(options),
                                              static_cast<double>(memoryLimitBytes()));
                    });
}

ExitCode run(const DecimateOptions& options) {
    Report report(options.zmap);
    DecimationParameters parameters;
    options.decimation.apply(parameters, {}, 0);
    auto zmap = prepare(options, parameters);
    if (!zmap) {
        report.addFatal(zmap.error());
        if (options.json)
            printJson({{"findings", report.findings()}, {"unverified", report.unverified()}});
        return report.exitCode();
    }
    const FileAllowance allowance(parameters, options.meshes.coordinates(), zmap->stock());
    SurfaceSnapshot result;
    MeasuredSurface measured;
    double seconds = 0;
    const auto make = [&](const DecimationParameters& of) {
        const StopWatch watch;
        result = decimatedWhole(*zmap, of);
        seconds += watch.seconds();
        measured = measure(result, *zmap, parameters);
        return true;
    };
    make(allowance.parameters());
    std::vector<MeshOutput> written;
    if (options.meshes.wanted())
        written = options.meshes.write(*zmap, result, allowance, make, report).value();
    const double error = largestErrorMm(measured.largestErrorMm, written, parameters.allowance);
    if (!options.json) {
        fmt::print("{} of {} triangles, largest vertical error {:.6f} mm, {:.3f} s\n", result.faces,
                   result.facesFull, error, seconds);
        printFiles(written);
        return report.exitCode();
    }
    nlohmann::ordered_json out{{"facesIn", result.facesFull},
                               {"facesOut", result.faces},
                               {"seconds", seconds},
                               {"largestErrorMm", error},
                               {"errorLevel", measured.level},
                               {"regions", result.grid.regionCount()},
                               {"method", kMethodChoices[static_cast<std::size_t>(parameters.method)].key}};
    out["forecastBytes"] = std::llround(mapBytes(zmap->grid(), parameters, mapOutputs(options)));
    out["peakBytes"] = peakMemoryBytes();
    options.meshes.addTo(out, written);
    out["findings"] = report.findings();
    out["unverified"] = report.unverified();
    printJson(out);
    return report.exitCode();
}

} // namespace

void addDecimateCommand(CLI::App& app, ExitCode& exitCode) {
    auto* command = app.add_subcommand("decimate", "Decimate a z-map");
    auto options = std::make_shared<DecimateOptions>();
    command->add_option("ZMAP", options->zmap, "Z-map: NPY, absolute heights, row 0 at min Y")
        ->type_name("")
        ->required();
    command->add_option("--grid", options->spacing, "Grid spacing, mm")->type_name("H")->required();
    command->add_option("--origin", options->origin, "Position of row 0, column 0, mm (0,0)")
        ->type_name("X,Y");
    command->add_option("--floor", options->floor, "Bottom of the stock, mm (5 mm below the lowest height)")
        ->type_name("Z");
    options->decimation.addTo(*command);
    options->threads.addTo(*command);
    options->meshes.addTo(*command);
    command->add_flag("--json", options->json, "Print one JSON object");
    command->callback([options, &exitCode] {
        options->threads.apply();
        exitCode = run(*options);
    });
}

} // namespace proveout::cli
