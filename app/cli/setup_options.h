// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/cli/decimation_options.h"
#include "app/cli/field_options.h"
#include "core/base/diagnostic.h"
#include "core/decimation/surface/map_memory.h"
#include "core/formats/job_file.h"
#include "core/nc/program/program.h"

namespace proveout::cli {

/// `--stock` and `--stock-origin`.
struct StockOptions {
    std::string spec;
    std::string origin;

    void addTo(CLI::App& command);
    /// Changes what is given; a saved stock brings the spacing of its grid with it.
    [[nodiscard]] Result<void> apply(Setup& setup) const;
    /// The file that the stock comes from, if it does.
    [[nodiscard]] std::string file() const;
};

/// `--tools` and `--tool`; the latter outrank the file.
struct ToolOptions {
    std::string file;
    std::vector<std::string> tools;

    void addTo(CLI::App& command);
    [[nodiscard]] bool given() const { return !file.empty() || !tools.empty(); }
    [[nodiscard]] Result<void> apply(ToolTable& table) const;
};

/// A warning where type B is asked for, and the control of the program knows no types.
[[nodiscard]] Diagnostics unusedCompensationStart(bool typeB, const Program& program);

/// The set-up of a run, from a job file, from options, or both: an option outranks the job.
class SetupOptions {
public:
    /// Adds PROG and the set-up options. This object must outlive the parsing.
    void addTo(CLI::App& command);

    [[nodiscard]] Result<Job> job() const;
    /// Finds the spacing of an automatic grid, and the region size where nobody named one.
    static void settleGrid(Job& job, const Program& program, const MapOutputs& outputs);
    /// Refuses a stock and a grid that cannot be, or need more memory than may be taken.
    [[nodiscard]] Result<void> checkGrid(const Job& job, const MapOutputs& outputs) const;
    [[nodiscard]] const DecimationOptions& decimation() const { return m_decimation; }
    [[nodiscard]] std::vector<std::string> inputs() const {
        return {m_program, m_jobFile, m_tools.file, m_stock.file()};
    }
    /// What messages without a place of their own are about.
    [[nodiscard]] const std::string& subject() const { return m_program.empty() ? m_jobFile : m_program; }

private:
    [[nodiscard]] Result<Job> readJobFile() const;
    [[nodiscard]] tl::unexpected<Diagnostics> aboutGrid(Diagnostics diagnostics) const;

    std::string m_program;
    std::string m_jobFile;
    bool m_allowOutside = false;
    StockOptions m_stock;
    ToolOptions m_tools;
    GivenFields m_given; ///< of grid and control
    std::string m_machine;
    DecimationOptions m_decimation;
};

} // namespace proveout::cli
