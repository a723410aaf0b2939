// SPDX-License-Identifier: GPL-3.0-or-later
// Which files outside its folder each job may name: what the user has said once is remembered in the
// settings.
#pragma once

#include <filesystem>
#include <vector>

#include <QString>

#include "core/formats/job_paths.h"

namespace proveout {

/// For a job in this file, as the settings are now. UI thread; the rule itself may be asked on any.
[[nodiscard]] OutsideRule allowedOutside(const QString& jobFile);

/// The job may name these files (outsideFiles()) from now on: the user has said so, or has saved it himself.
/// The newest thousand are remembered, as digests, so that the settings tell no names. UI thread.
void allowOutside(const QString& jobFile, const std::vector<std::filesystem::path>& files);

} // namespace proveout
