// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include <nlohmann/json.hpp>

#include "core/base/diagnostic.h"

namespace proveout::cli {

/// The results of a check that may be interrupted and continued: a file of JSON Lines, to which each result
/// is added as soon as it is known.
class CheckResults {
public:
    /// Reads the results that an earlier check with the same `settings` has left; a line that is not complete
    /// is left out. Errors: the file cannot be read or written.
    [[nodiscard]] Result<void> open(const std::filesystem::path& file, const std::string& settings);
    /// The result of an input whose files have not changed since; null if there is none.
    [[nodiscard]] const nlohmann::ordered_json* find(const std::filesystem::path& input) const;
    /// Adds a line and flushes it to the system.
    void add(const nlohmann::ordered_json& checked);

private:
    std::map<std::string, nlohmann::ordered_json> m_known; ///< by input
    std::ofstream m_out;
};

/// One line without its end; bytes that are not UTF-8 are replaced.
[[nodiscard]] std::string jsonLine(const nlohmann::ordered_json& object);

} // namespace proveout::cli
