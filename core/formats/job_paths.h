// SPDX-License-Identifier: GPL-3.0-or-later
// How a job names other files, and which of them may be read.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

namespace proveout {

struct Job;

/// Whether a job may name a file outside its folder; the path is absolute, with symbolic links resolved.
/// Null: no such file is allowed. A job from another source must not cause other files of this computer to be
/// read.
using OutsideRule = std::function<bool(const std::filesystem::path& file)>;

/// Allows every file; for callers whose user has agreed to that.
[[nodiscard]] bool anyOutside(const std::filesystem::path& file);

/// Absolute, with symbolic links resolved in the part of the path that exists.
[[nodiscard]] std::filesystem::path absolutePath(const std::filesystem::path& path);

/// The folder to which the names in a job file are relative: that of the file itself, not of a link to it.
[[nodiscard]] std::filesystem::path folderOfJob(const std::filesystem::path& jobFile);

/// Whether a file is neither in the folder nor below it, with symbolic links resolved. Both arguments come
/// from absolutePath().
[[nodiscard]] bool isOutside(const std::filesystem::path& folder, const std::filesystem::path& file);

/// The files that a job names: its program, that of its stock, those of its fixtures.
[[nodiscard]] std::vector<std::filesystem::path> filesOf(const Job& job);

/// Those that a job in this file would name outside its folder, without repetition.
[[nodiscard]] std::vector<std::filesystem::path> outsideFiles(const std::filesystem::path& jobFile,
                                                              const Job& job);

} // namespace proveout
