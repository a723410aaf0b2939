// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/mesh_outputs.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "core/base/memory.h"
#include "core/decimation/regions/region_decimator.h"
#include "core/decimation/solid/solid.h"

namespace proveout::cli {

void MeshOutputs::addTo(CLI::App& command) {
    command
        .add_option("--export", m_exports,
                    "Write the stock as a closed solid; the file name extension sets the format (" +
                        meshEndings() + "); repeatable")
        ->type_name("FILE")
        ->allow_extra_args(false);
    command.add_option("--stl", m_stl, "The same as STL, whatever the file name extension")
        ->type_name("F.stl");
    command.add_flag("--ascii", m_asciiStl, "Write STL as text");
}

std::vector<std::string> MeshOutputs::files() const {
    std::vector<std::string> files = m_exports;
    if (!m_stl.empty())
        files.push_back(m_stl);
    return files;
}

std::vector<Output> MeshOutputs::outputs(const Grid* fullMesh) const {
    std::vector<Output> outputs;
    for (const std::string& file : files())
        outputs.push_back(
            {file, fullMesh == nullptr ? 0 : fullMeshBytes(*formatOf(file).meshWriter(), *fullMesh)});
    return outputs;
}

Result<void> MeshOutputs::check() const {
    for (const std::string& file : m_exports)
        if (auto format = meshFormatOf(file); !format)
            return tl::unexpected(std::move(format.error()));
    return {};
}

CoordinateType MeshOutputs::coordinates() const {
    const auto type = [this](const std::string& file) { return formatOf(file).meshWriter()->coordinates; };
    const std::vector<std::string> all = files();
    return std::ranges::any_of(all, [&](const auto& file) { return type(file) == CoordinateType::float32; })
               ? CoordinateType::float32
               : CoordinateType::float64;
}

const FileFormat& MeshOutputs::formatOf(const std::string& file) const {
    const FileFormat* binary = findFormat("stl");
    const FileFormat* format = file == m_stl ? binary : meshFormatOf(file).value(); // check() has succeeded
    return format == binary && m_asciiStl ? *findFormat("stl-ascii") : *format;
}

Result<void> MeshOutputs::checkRounding(const DecimationParameters& promised, const StockBox& stock) const {
    for (const std::string& file : files())
        if (auto fine =
                proveout::checkRounding(file, formatOf(file).meshWriter()->coordinates, promised, stock);
            !fine)
            return fine;
    return {};
}

std::optional<std::vector<MeshOutput>> MeshOutputs::write(ZMapSnapshot& zmap, SurfaceSnapshot& surface,
                                                          FileAllowance allowance, const MakeAgain& makeAgain,
                                                          Report& report) const {
    const DecimationParameters promised = allowance.promised();
    const ErrorLevel level = errorLevel(promised);
    const std::size_t wallPoints = zmap.walls().count();
    const auto closeOnce = [&]() -> std::optional<SolidForExport> {
        if (!zmap.walls().empty()) {
            if (auto walled = closeWithWalls(zmap, surface.releaseTriangles(), promised, coordinates()))
                return SolidForExport(zmap, std::move(*walled), level, coordinates());
            zmap.setWalls({}); // and then their points are not needed
            if (!makeAgain(allowance.parameters()))
                return std::nullopt;
        }
        return SolidForExport(zmap, closeSolid(zmap, surface.releaseTriangles()), level);
    };
    const auto close = [&] {
        std::optional<SolidForExport> solid = closeOnce();
        if (solid)
            solid->setWallPoints(wallPoints);
        return solid;
    };
    std::optional<SolidForExport> solid = close();
    while (solid && allowance.reduce(*solid)) {
        solid.reset(); // two of them may not fit into memory
        if (!makeAgain(allowance.parameters()))
            return std::nullopt;
        solid = close();
    }
    return solid ? std::optional(writeAll(*solid, allowance, report)) : std::nullopt;
}

std::vector<MeshOutput> MeshOutputs::writeAll(SolidForExport& solid, const FileAllowance& allowance,
                                              Report& report) const {
    std::vector<MeshOutput> written;
    for (const std::string& file : files()) {
        const FileFormat& format = formatOf(file);
        auto exported = allowance.check(file, format.meshWriter()->coordinates).and_then([&] {
            return exportSolid(file, *format.meshWriter(), solid, allowance.promised());
        });
        if (!exported) {
            report.addFatal(std::move(exported.error()));
            continue;
        }
        report.add(exported->warnings);
        written.push_back({file, &format, std::move(*exported)});
    }
    return written;
}

void MeshOutputs::addTo(nlohmann::ordered_json& object, const std::vector<MeshOutput>& written) const {
    if (!wanted())
        return;
    auto rows = nlohmann::ordered_json::array();
    for (const auto& [file, format, exported] : written) {
        const nlohmann::ordered_json figures{{"triangles", exported.file.triangles},
                                             {"bytes", exported.file.bytes},
                                             {"coordinates", nameOf(format->meshWriter()->coordinates)},
                                             {"largestErrorMm", exported.largestErrorMm}};
        if (file == m_stl)
            object["stl"] = figures;
        nlohmann::ordered_json row{{"file", file}, {"format", format->key}};
        row.update(figures);
        rows.push_back(std::move(row));
    }
    object["exports"] = std::move(rows);
}

void printFiles(const std::vector<MeshOutput>& written) {
    for (const auto& [file, format, exported] : written)
        fmt::print("{}: {} triangles, {}, largest vertical error {:.6f} mm\n", file, exported.file.triangles,
                   readableBytes(static_cast<double>(exported.file.bytes)), exported.largestErrorMm);
}

double largestErrorMm(double surfaceErrorMm, const std::vector<MeshOutput>& written, double allowance) {
    constexpr double kWorthCounting = 0.01; // share of the error allowance
    double largest = surfaceErrorMm;
    for (const MeshOutput& output : written)
        if (output.exported.largestErrorMm > surfaceErrorMm + kWorthCounting * allowance)
            largest = std::max(largest, output.exported.largestErrorMm);
    return largest;
}

} // namespace proveout::cli
