// SPDX-License-Identifier: GPL-3.0-or-later
// Which files outside its folder each job may name; the user's permissions are stored in the settings.
#pragma once

#include <filesystem>
#include <vector>

#include <QString>

#include "core/formats/job_paths.h"

namespace proveout {

/// The rule for a job in this file with the current settings. Call it on the UI thread; the rule itself may
/// be called on any thread.
[[nodiscard]] OutsideRule allowedOutside(const QString& jobFile);

/// Allows the job to name these files (outsideFiles()) from now on, because the user agreed or has saved the
/// job. The newest thousand are stored, as digests, so that the settings reveal no file names. UI thread.
void allowOutside(const QString& jobFile, const std::vector<std::filesystem::path>& files);

} // namespace proveout
