// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "core/base/diagnostic.h"

namespace proveout {

/// Makes an empty file "name-2.nc" beside "name.nc", or with the next number that is free; no file that is
/// there is touched, whoever makes one at the same moment. Any thread. Errors: the folder cannot be written.
[[nodiscard]] Result<std::filesystem::path> newFileBeside(const std::filesystem::path& file);

} // namespace proveout
