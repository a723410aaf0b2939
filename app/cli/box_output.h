// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/outputs.h"
#include "app/cli/report.h"
#include "core/formats/job_file.h"
#include "core/formats/solid_export.h"
#include "core/simulation/records/box_of_interest.h"

namespace proveout::cli {

/// The detail region requested from `simulate`: `--box`, its spacing and its files.
class BoxOutput {
public:
    /// This object must outlive the parsing.
    void addTo(CLI::App& command);

    [[nodiscard]] bool wanted() const { return !m_box.empty(); }
    /// Its files; their sizes are known after check().
    [[nodiscard]] std::vector<Output> outputs() const;
    /// Refuses a region that cannot be cut, or needs more memory than is available besides `heldBytes`,
    /// before anything is cut. `hasWalls`: it gets its walls where they stand.
    [[nodiscard]] Result<void> check(const Setup& setup, bool hasWalls, double heldBytes);
    /// The memory that the region needs; call check() first.
    [[nodiscard]] double bytes() const;

    /// Cuts the region after the first `blocks` blocks, and writes its files; call check() first. Warnings
    /// and errors are added to the report.
    void run(const std::shared_ptr<const Program>& program, const std::shared_ptr<const Setup>& setup,
             std::size_t blocks, Report& report);

    [[nodiscard]] nlohmann::ordered_json object() const;
    void print() const;

private:
    [[nodiscard]] MapOutputs mapOutputs() const;
    void writeStl(Report& report);
    [[nodiscard]] SolidForExport closed(const DecimationParameters& parameters);

    std::string m_box;
    std::string m_stl;
    std::string m_heights;
    double m_spacing = BoxOfInterest().spacing;

    GridPart m_part;
    bool m_checked = false; ///< m_part is set
    bool m_hasWalls = false;
    FineMap m_fine;
    std::optional<ExportedSolid> m_exported;
};

} // namespace proveout::cli
