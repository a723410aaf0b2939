// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/tool_number.h"

#include <charconv>
#include <system_error>

namespace proveout {

std::optional<int> parseToolNumber(std::string_view text) {
    int number = 0;
    const char* const end = text.data() + text.size();
    const auto [read, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc() || read != end || number < kLeastTool || number > kLargestTool)
        return std::nullopt;
    return number;
}

} // namespace proveout
