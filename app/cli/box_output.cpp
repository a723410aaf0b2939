// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/box_output.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "app/cli/option_error.h"
#include "app/cli/zmap_file.h"
#include "core/base/memory.h"
#include "core/decimation/solid/solid.h"
#include "core/decimation/surface/refined_surface.h"
#include "core/formats/formats.h"
#include "core/verification/findings/command_line_findings.h"
#include "core/zmap/zmap_findings.h"

namespace proveout::cli {

namespace {

Result<PlanBox> parseBox(const std::string& text) {
    std::array<double, 4> values{};
    const char* at = text.data();
    const char* const end = at + text.size();
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (k > 0 && (at == end || *at++ != ','))
            return failure(command_line_finding::kBoxForm, {text});
        const auto [next, error] = std::from_chars(at, end, values[k]);
        if (error != std::errc{} || !std::isfinite(values[k]))
            return failure(command_line_finding::kBoxForm, {text});
        at = next;
    }
    if (at != end)
        return failure(command_line_finding::kBoxForm, {text});
    return PlanBox{{values[0], values[1]}, {values[2], values[3]}};
}

} // namespace

void BoxOutput::addTo(CLI::App& command) {
    auto* box = command
                    .add_option("--box", m_box,
                                "Cut this box of the stock again on a finer grid; its heights equal those of "
                                "the whole stock on that grid")
                    ->type_name("X0,Y0,X1,Y1");
    command.add_option("--box-spacing", m_spacing, "Grid spacing in the box, mm (0.01)")
        ->type_name("H")
        ->needs(box);
    command.add_option("--box-stl", m_stl, "Write the box as a closed solid, accurate to half its spacing")
        ->type_name("F.stl")
        ->needs(box);
    command.add_option("--box-heights", m_heights, "Write the heights in the box (NPY)")
        ->type_name("F.npy")
        ->needs(box);
}

MapOutputs BoxOutput::mapOutputs() const {
    const bool solid = !m_stl.empty();
    return {.schedule = false, .whole = solid, .solid = solid, .walls = m_hasWalls};
}

double BoxOutput::bytes() const {
    return boxBytes(m_part, fineParameters(m_spacing), mapOutputs());
}

std::vector<Output> BoxOutput::outputs() const {
    return {{m_stl}, {m_heights, m_checked ? heightsBytes(m_part.nx, m_part.ny) : 0}};
}

Result<void> BoxOutput::check(const Setup& setup, bool hasWalls, double heldBytes) {
    if (!wanted())
        return {};
    m_hasWalls = hasWalls;
    auto box = parseBox(m_box);
    if (!box)
        return aboutOption("--box", std::move(box.error()));
    const double limit = std::max(0.0, static_cast<double>(memoryLimitBytes()) - heldBytes);
    auto part = fineGrid(setup, {*box, m_spacing}, fineParameters(m_spacing), mapOutputs(), limit);
    if (!part) {
        const Diagnostic& reason = part.error().front();
        const bool aboutBox =
            hasIdOf(reason, zmap_finding::kBoxOutsideStock) || hasIdOf(reason, zmap_finding::kBoxWithoutArea);
        return aboutOption(aboutBox ? "--box" : "--box-spacing", std::move(part.error()));
    }
    m_part = *part;
    m_checked = true;
    return {};
}

void BoxOutput::run(const std::shared_ptr<const Program>& program, const std::shared_ptr<const Setup>& setup,
                    std::size_t blocks, Report& report) {
    if (!wanted())
        return;
    m_fine = *cutBox(*program, *setup, blocks, m_part); // always completes, because nothing stops it
    if (m_hasWalls)
        (void)addWalls(m_fine, program, setup); // so does this
    if (!m_heights.empty())
        if (auto written = writeZMap(m_heights, m_fine.zmap); !written)
            report.addFatal(std::move(written.error()));
    if (!m_stl.empty())
        writeStl(report);
}

void BoxOutput::writeStl(Report& report) {
    const DecimationParameters parameters = fineParameters(m_spacing);
    SolidForExport solid = closed(parameters);
    auto exported = exportSolid(m_stl, *findFormat("stl")->meshWriter(), solid, parameters);
    if (!exported)
        return report.addFatal(std::move(exported.error()));
    report.add(exported->warnings);
    m_exported = std::move(*exported);
}

SolidForExport BoxOutput::closed(const DecimationParameters& parameters) {
    const std::size_t wallPoints = m_fine.zmap.walls().count();
    const ErrorLevel level = errorLevel(parameters);
    if (wallPoints > 0) {
        if (auto walled =
                closeWithWalls(m_fine.zmap, decimatedWhole(m_fine.zmap, parameters).releaseTriangles(),
                               parameters, CoordinateType::float32)) {
            SolidForExport solid(m_fine.zmap, std::move(*walled), level, CoordinateType::float32);
            solid.setWallPoints(wallPoints);
            return solid;
        }
        m_fine.zmap.setWalls({});
    }
    SolidForExport solid(m_fine.zmap,
                         closeSolid(m_fine.zmap, decimatedWhole(m_fine.zmap, parameters).releaseTriangles()),
                         level);
    solid.setWallPoints(wallPoints);
    return solid;
}

nlohmann::ordered_json BoxOutput::object() const {
    const Grid& grid = m_fine.zmap.grid();
    nlohmann::ordered_json out{{"x", {grid.x(0), grid.x(grid.nx - 1)}},
                               {"y", {grid.y(0), grid.y(grid.ny - 1)}},
                               {"grid", {{"nx", grid.nx}, {"ny", grid.ny}, {"hx", grid.hx}, {"hy", grid.hy}}},
                               {"points", static_cast<std::int64_t>(grid.nx) * grid.ny},
                               {"block", m_fine.block},
                               {"motions", m_fine.motions},
                               {"seconds", m_fine.seconds}};
    if (const RimMap& rims = m_fine.zmap.rims(); !rims.empty()) {
        out["rims"] = countOf(rims);
        out["rimTilesUnknown"] = unknownTiles(rims);
        out["ribsUnseen"] = unseenRibs(rims);
    }
    if (m_exported)
        out["stl"] = {{"triangles", m_exported->file.triangles},
                      {"bytes", m_exported->file.bytes},
                      {"largestErrorMm", m_exported->largestErrorMm}};
    return out;
}

void BoxOutput::print() const {
    if (!wanted())
        return;
    const Grid& grid = m_fine.zmap.grid();
    fmt::print("box: {} × {} points, spacing {:.4g} mm, cut by {} motions in {:.3f} s\n", grid.nx, grid.ny,
               grid.hx, m_fine.motions, m_fine.seconds);
    if (m_exported)
        fmt::print("{}: {} triangles, {}, largest vertical error {:.6f} mm\n", m_stl,
                   m_exported->file.triangles, readableBytes(static_cast<double>(m_exported->file.bytes)),
                   m_exported->largestErrorMm);
}

} // namespace proveout::cli
