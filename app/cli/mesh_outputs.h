// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/outputs.h"
#include "app/cli/report.h"
#include "core/decimation/regions/parameters.h"
#include "core/decimation/surface/surface.h"
#include "core/formats/file_allowance.h"
#include "core/formats/solid_export.h"

namespace proveout::cli {

/// A mesh file that was written.
struct MeshOutput {
    std::string file;
    const FileFormat* format = nullptr;
    ExportedSolid exported;
};

/// The mesh files requested from a command: `--export`, whose extension selects the format, and `--stl`.
class MeshOutputs {
public:
    /// This object must outlive the parsing.
    void addTo(CLI::App& command);

    [[nodiscard]] bool wanted() const { return !m_stl.empty() || !m_exports.empty(); }
    [[nodiscard]] std::vector<std::string> files() const;
    /// The files; with a grid, including the sizes of a full mesh on it. Call check() first.
    [[nodiscard]] std::vector<Output> outputs(const Grid* fullMesh = nullptr) const;
    /// Refuses extensions that do not belong to a mesh format.
    [[nodiscard]] Result<void> check() const;

    /// The type of the coordinates of all files: single precision if one of them has it.
    [[nodiscard]] CoordinateType coordinates() const;

    /// Refuses the files that cannot keep the allowance of a surface with these parameters, whatever is cut.
    [[nodiscard]] Result<void> checkRounding(const DecimationParameters& promised,
                                             const StockBox& stock) const;

    /// Makes the surface again with other parameters; false if that is not possible.
    using MakeAgain = std::function<bool(const DecimationParameters&)>;
    /// Closes a surface of `zmap`, made for `allowance`, into a solid, consuming its triangles, and writes
    /// every file. If not all walls of `zmap` can be drawn where they stand, it loses them first, and the
    /// surface is made again. If a file would exceed the promised allowance, `surface` is first made again
    /// for less, by `makeAgain`; if that is false, nothing is written and the result empty. Warnings and
    /// errors are added to the report.
    [[nodiscard]] std::optional<std::vector<MeshOutput>> write(ZMapSnapshot& zmap, SurfaceSnapshot& surface,
                                                               FileAllowance allowance,
                                                               const MakeAgain& makeAgain,
                                                               Report& report) const;
    /// Adds "exports", one row per file, and "stl" if that option was given.
    void addTo(nlohmann::ordered_json& object, const std::vector<MeshOutput>& written) const;

private:
    [[nodiscard]] const FileFormat& formatOf(const std::string& file) const;
    [[nodiscard]] std::vector<MeshOutput> writeAll(SolidForExport& solid, const FileAllowance& allowance,
                                                   Report& report) const;

    std::string m_stl;
    std::vector<std::string> m_exports;
    bool m_asciiStl = false;
};

/// Prints one line per file.
void printFiles(const std::vector<MeshOutput>& written);

/// The largest error of a surface and of the files that it was written to. The rounding error is included if
/// it exceeds a hundredth of the error allowance.
[[nodiscard]] double largestErrorMm(double surfaceErrorMm, const std::vector<MeshOutput>& written,
                                    double allowance);

} // namespace proveout::cli
