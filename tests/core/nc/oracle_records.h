// SPDX-License-Identifier: GPL-3.0-or-later
// The results of LinuxCNC's stand-alone interpreter that are stored next to the programs of the corpus.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/nc/state/tool_offsets.h"

namespace proveout::test {

struct OracleAnswer {
    std::vector<nlohmann::json> records; ///< motions and the events that can be compared, in sequence
    int errorLine = 0;                   ///< line of the first error; 0: none, -1: an error without a line
    std::string errorClass;
    std::string errorText;
    bool compensated = false; ///< cutter compensation is used anywhere
    bool cut = false;         ///< some records were dropped
    /// Why the stand-alone machine is at another position than a real LinuxCNC machine from there on; empty:
    /// it is not. Records end there.
    std::string lost;
};

/// Programs below `root` that have an answer, plain or compressed with gzip.
std::vector<std::filesystem::path> programsWithAnswer(const std::filesystem::path& root);

/// The lengths and diameters with which the answer was produced.
ToolOffsets toolsOfAnswer(const std::filesystem::path& program);

OracleAnswer readAnswer(const std::filesystem::path& program);

} // namespace proveout::test
