// SPDX-License-Identifier: GPL-3.0-or-later
// The answers of LinuxCNC's stand-alone interpreter that stand beside the programs of the corpus.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace proveout::test {

struct OracleAnswer {
    std::vector<nlohmann::json> records; ///< motions and the events that can be compared, in order
    int errorLine = 0;                   ///< of the first error; 0: none, -1: an error without a line
    std::string errorClass;
    std::string errorText;
    bool cut = false; ///< not all records are kept
};

/// Programs below `root` that have an answer, plain or packed by gzip.
std::vector<std::filesystem::path> programsWithAnswer(const std::filesystem::path& root);

OracleAnswer readAnswer(const std::filesystem::path& program);

} // namespace proveout::test
