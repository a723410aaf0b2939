// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/file_state.h"

#include <system_error>

namespace proveout {

FileState stateOf(const std::filesystem::path& file) {
    std::error_code error;
    const std::uintmax_t bytes = std::filesystem::file_size(file, error);
    if (error)
        return {};
    const auto modified = std::filesystem::last_write_time(file, error);
    return error ? FileState() : FileState{bytes, modified};
}

} // namespace proveout
