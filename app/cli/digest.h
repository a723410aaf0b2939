// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace proveout::cli {

/// The SHA-256 of the content of a regular file, in hexadecimal; nothing if it cannot be read.
[[nodiscard]] std::optional<std::string> sha256(const std::filesystem::path& file);

} // namespace proveout::cli
