// SPDX-License-Identifier: GPL-3.0-or-later
// How a job names other files, and which of them it may have read.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

namespace proveout {

struct Job;

/// Whether a job may name a file outside its folder, which is absolute, with symbolic links resolved. Null:
/// no such file. A job that comes from elsewhere must not have other files of this computer read.
using OutsideRule = std::function<bool(const std::filesystem::path& file)>;

/// Every file, for who was told so by the user.
[[nodiscard]] bool anyOutside(const std::filesystem::path& file);

/// Absolute, with the symbolic links resolved of as much of it as exists.
[[nodiscard]] std::filesystem::path absolutePath(const std::filesystem::path& path);

/// The folder that the names in a job file start from: where the file itself is, not a link to it.
[[nodiscard]] std::filesystem::path folderOfJob(const std::filesystem::path& jobFile);

/// Whether a file is neither in the folder nor below it, wherever symbolic links lead. Both are
/// absolutePath().
[[nodiscard]] bool isOutside(const std::filesystem::path& folder, const std::filesystem::path& file);

/// The files that a job in this file would name outside its folder: program and stock, without repetition.
[[nodiscard]] std::vector<std::filesystem::path> outsideFiles(const std::filesystem::path& jobFile,
                                                              const Job& job);

} // namespace proveout
