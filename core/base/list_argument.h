// SPDX-License-Identifier: GPL-3.0-or-later
// Several texts of the core as one argument of a diagnostic: each is translated separately, and they are
// shown with commas between them.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace proveout {

inline constexpr std::string_view kListSeparator = "\x1f,\x1f"; ///< does not occur in any text that is shown

[[nodiscard]] inline std::string listArgument(const std::vector<std::string>& texts) {
    std::string argument;
    for (const std::string& text : texts) {
        if (!argument.empty())
            argument += kListSeparator;
        argument += text;
    }
    return argument;
}

/// `list`, with `change(text)` in place of each text.
template<class Change>
[[nodiscard]] std::string changedList(std::string_view list, std::string_view separator, Change&& change) {
    std::string out;
    for (std::size_t begin = 0;;) {
        const std::size_t end = std::min(list.find(kListSeparator, begin), list.size());
        out += change(list.substr(begin, end - begin));
        if (end == list.size())
            return out;
        out += separator;
        begin = end + kListSeparator.size();
    }
}

} // namespace proveout
