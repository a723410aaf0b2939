// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "core/base/diagnostic.h"

namespace proveout {

/// Creates an empty file "name-2.nc" next to "name.nc", or with the next free number. An existing file is
/// never touched, even if another process creates one at the same moment. Any thread. Errors: the folder is
/// not writable.
[[nodiscard]] Result<std::filesystem::path> newFileBeside(const std::filesystem::path& file);

} // namespace proveout
