// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a case with the real command line, measured by the system.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/app/measured_run.h"
#include "tests/bench/faults/fault_cases.h"

namespace proveout {

struct FaultRun : MeasuredRun {
    std::vector<std::string> messages;
};

class FaultRunner {
public:
    /// Runs are executed in `folder`, with relative paths.
    FaultRunner(std::filesystem::path program, std::filesystem::path folder)
        : m_program(std::move(program)), m_folder(std::move(folder)) {}

    /// Simulates and exports. A run of more than a minute is killed.
    [[nodiscard]] FaultRun run(const FaultCase& fault) const;
    [[nodiscard]] const std::filesystem::path& folder() const { return m_folder; }

private:
    [[nodiscard]] std::vector<std::string> commandLine(const FaultCase& fault) const;

    std::filesystem::path m_program;
    std::filesystem::path m_folder;
};

} // namespace proveout
