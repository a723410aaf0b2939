// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/outputs.h"
#include "app/cli/report.h"
#include "core/decimation/regions/parameters.h"
#include "core/decimation/surface/surface.h"
#include "core/formats/solid_export.h"

namespace proveout::cli {

/// A mesh file that was written.
struct MeshOutput {
    std::string file;
    const FileFormat* format = nullptr;
    ExportedSolid exported;
};

/// The mesh files that a command is asked for: `--export`, whose ending names the format, and `--stl`.
class MeshOutputs {
public:
    /// This object must outlive the parsing.
    void addTo(CLI::App& command);

    [[nodiscard]] bool wanted() const { return !m_stl.empty() || !m_exports.empty(); }
    [[nodiscard]] std::vector<std::string> files() const;
    /// The files; with a grid, of a full mesh on which the sizes are known. check() was asked.
    [[nodiscard]] std::vector<Output> outputs(const Grid* fullMesh = nullptr) const;
    /// Refuses endings that no mesh format has.
    [[nodiscard]] Result<void> check() const;

    /// Closes a surface of these parameters into a solid, taking its triangles, and writes every file.
    /// Warnings and errors go to the report.
    [[nodiscard]] std::vector<MeshOutput> write(const ZMapSnapshot& zmap, SurfaceSnapshot& surface,
                                                const DecimationParameters& parameters, Report& report) const;
    /// Adds "exports", one row a file, and "stl" where that option was given.
    void addTo(nlohmann::ordered_json& object, const std::vector<MeshOutput>& written) const;

private:
    [[nodiscard]] const FileFormat& formatOf(const std::string& file) const;

    std::string m_stl;
    std::vector<std::string> m_exports;
    bool m_asciiStl = false;
};

/// One line a file.
void printFiles(const std::vector<MeshOutput>& written);

/// The largest error of a surface and of the files that it was written to. What rounding adds counts where it
/// is more than a hundredth of the error allowance.
[[nodiscard]] double largestErrorMm(double surfaceErrorMm, const std::vector<MeshOutput>& written,
                                    double allowance);

} // namespace proveout::cli
