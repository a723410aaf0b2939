// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

/// The box of interest that `simulate` is asked for: `--box`, its spacing and its files.
class BoxOutput {
public:
    /// This object must outlive the parsing.
    void addTo(CLI::App& command);

    [[nodiscard]] bool wanted() const { return !m_box.empty(); }
    /// Its files, with their sizes as far as check() has found them.
    [[nodiscard]] std::vector<Output> outputs() const;
    /// Refuses a box that cannot be cut, or needs more memory than may be taken beside `heldBytes`, before
    /// anything is cut.
    [[nodiscard]] Result<void> check(const Setup& setup, double heldBytes);
    /// That the box takes; check() was asked.
    [[nodiscard]] double bytes() const;

    /// Cuts the box after the first `blocks` blocks, and writes its files; check() was asked. Warnings and
    /// errors go to the report.
    void run(const Program& program, const Setup& setup, std::size_t blocks, Report& report);

    [[nodiscard]] nlohmann::ordered_json object() const;
    void print() const;

private:
    [[nodiscard]] MapOutputs mapOutputs() const;
    void writeStl(Report& report);

    std::string m_box;
    std::string m_stl;
    std::string m_heights;
    double m_spacing = BoxOfInterest().spacing;

    GridPart m_part;
    bool m_checked = false; ///< m_part is known
    FineMap m_fine;
    std::optional<ExportedSolid> m_exported;
};

} // namespace proveout::cli
