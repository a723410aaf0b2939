// SPDX-License-Identifier: GPL-3.0-or-later
// The answers of LinuxCNC's stand-alone interpreter that stand beside the programs of the corpus.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/nc/state/tool_offsets.h"

namespace proveout::test {

struct OracleAnswer {
    std::vector<nlohmann::json> records; ///< motions and the events that can be compared, in order
    int errorLine = 0;                   ///< of the first error; 0: none, -1: an error without a line
    std::string errorClass;
    std::string errorText;
    bool compensated = false; ///< by the radius of a cutter, anywhere
    bool cut = false;         ///< not all records are kept
    /// Why the stand-alone machine is from there on not where LinuxCNC's would be; empty: it is. Records end
    /// there.
    std::string lost;
};

/// Programs below `root` that have an answer, plain or packed by gzip.
std::vector<std::filesystem::path> programsWithAnswer(const std::filesystem::path& root);

/// The lengths and diameters with which the answer to a program was found.
ToolOffsets toolsOfAnswer(const std::filesystem::path& program);

OracleAnswer readAnswer(const std::filesystem::path& program);

} // namespace proveout::test
