// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/described_values.h"

namespace proveout {

std::optional<ValuesWithFile> valuesBeforeFile(std::string_view text) {
    constexpr std::string_view kFile = "file=";
    constexpr std::string_view kNextFile = ",file=";
    const bool isAlone = text.starts_with(kFile);
    const std::size_t comma = isAlone ? 0 : text.find(kNextFile);
    if (comma == std::string_view::npos)
        return std::nullopt;
    const std::string_view file = text.substr(comma + (isAlone ? kFile : kNextFile).size());
    return file.empty() ? std::nullopt : std::optional(ValuesWithFile{text.substr(0, comma), file});
}

} // namespace proveout
