// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/cli/decimation_options.h"
#include "app/cli/field_options.h"
#include "core/base/diagnostic.h"
#include "core/decimation/surface/map_memory.h"
#include "core/formats/job_file.h"
#include "core/nc/program/program.h"
#include "core/part/part_spec.h"

namespace proveout::cli {

/// `--stock` and `--stock-origin`.
struct StockOptions {
    std::string spec;
    std::string origin;

    void addTo(CLI::App& command);
    /// Applies the given options; a saved stock also sets the grid spacing.
    [[nodiscard]] Result<void> apply(Setup& setup) const;
    /// The file of the stock, if it has one.
    [[nodiscard]] std::string file() const;
};

/// `--tools` and `--tool`; the latter take precedence over the file.
struct ToolOptions {
    std::string file;
    std::vector<std::string> tools;

    void addTo(CLI::App& command);
    [[nodiscard]] bool given() const { return !file.empty() || !tools.empty(); }
    [[nodiscard]] Result<void> apply(ToolTable& table) const;
};

/// `--fixture`; added to those of the job, or in place of one with its name.
struct FixtureOptions {
    std::vector<std::string> fixtures;

    void addTo(CLI::App& command);
    [[nodiscard]] Result<void> apply(Fixtures& into) const;
};

/// `--part` and `--tolerance`.
struct PartOptions {
    std::string part;
    std::string tolerance;

    void addTo(CLI::App& command);
    /// Values that are not given stay those of the job.
    [[nodiscard]] Result<void> apply(std::optional<PartSpec>& into) const;
};

/// A warning if type B is requested but the control of the program does not distinguish types.
[[nodiscard]] Diagnostics unusedCompensationStart(bool typeB, const Program& program);

/// The setup of a run, from a job file, from options, or both: an option takes precedence over the job.
class SetupOptions {
public:
    /// Adds PROG and the setup options. This object must outlive the parsing.
    void addTo(CLI::App& command);

    /// The same without PROG and the job file, for a command that has many of them.
    void addSharedTo(CLI::App& command);

    [[nodiscard]] Result<Job> job() const;
    /// The job of one of them, which is a program or a job file; without a stock the default one.
    [[nodiscard]] Result<Job> jobOf(const std::string& file, bool isJobFile) const;
    [[nodiscard]] bool stockGiven() const { return !m_jobFile.empty() || !m_stock.spec.empty(); }
    /// Determines the spacing of an automatic grid, and the region size if it was not set.
    static void settleGrid(Job& job, const Program& program, const MapOutputs& outputs);
    /// Refuses a stock or a grid that is invalid or needs more memory than is available.
    [[nodiscard]] Result<void> checkGrid(const Job& job, const MapOutputs& outputs) const;
    [[nodiscard]] const DecimationOptions& decimation() const { return m_decimation; }
    [[nodiscard]] std::vector<std::string> inputs() const {
        return {m_program, m_jobFile, m_tools.file, m_stock.file()};
    }
    /// The file that messages without a file of their own refer to.
    [[nodiscard]] const std::string& subject() const { return m_program.empty() ? m_jobFile : m_program; }

private:
    [[nodiscard]] Result<Job> readJobFile() const;
    /// The job by file and options.
    [[nodiscard]] Result<Job> givenJob() const;
    [[nodiscard]] tl::unexpected<Diagnostics> aboutGrid(Diagnostics diagnostics) const;

    std::string m_program;
    std::string m_jobFile;
    bool m_allowOutside = false;
    StockOptions m_stock;
    ToolOptions m_tools;
    FixtureOptions m_fixtures;
    GivenFields m_given; ///< for grid and control
    std::string m_machine;
    DecimationOptions m_decimation;
};

} // namespace proveout::cli
