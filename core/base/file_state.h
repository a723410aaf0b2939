// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>

namespace proveout {

/// Shows, without reading a file, whether it has changed. Value type.
struct FileState {
    static constexpr std::uintmax_t kMissing = std::numeric_limits<std::uintmax_t>::max();

    std::uintmax_t bytes = kMissing;
    std::filesystem::file_time_type modified;

    friend bool operator==(const FileState&, const FileState&) = default;
};

/// Any thread.
[[nodiscard]] FileState stateOf(const std::filesystem::path& file);

} // namespace proveout
