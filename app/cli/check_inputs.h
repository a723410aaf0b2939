// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace proveout::cli {

/// The programs and jobs to check: the given files as they are, and of each folder all files below it whose
/// names end as those of programs and jobs do, sorted by name. Links to folders are not followed.
[[nodiscard]] std::vector<std::filesystem::path> filesToCheck(const std::vector<std::string>& inputs);

/// By its name.
[[nodiscard]] bool isJob(const std::filesystem::path& file);

} // namespace proveout::cli
