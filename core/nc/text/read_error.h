// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>

#include "core/nc/text/messages.h"

namespace proveout {

/// Why a line could not be read: the first part of it that has no meaning.
struct ReadError {
    const FindingRow* message = nullptr;
    int column = 0; ///< 1-based
    int length = 0;
    std::string_view argument; ///< a part of the line
};

/// About the bytes [begin, end) of a line, at least one.
[[nodiscard]] inline ReadError readError(const FindingRow& message, std::size_t begin, std::size_t end,
                                         std::string_view argument = {}) {
    return {&message, static_cast<int>(begin + 1), static_cast<int>((end > begin ? end : begin + 1) - begin),
            argument};
}

} // namespace proveout
