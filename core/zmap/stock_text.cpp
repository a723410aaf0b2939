// SPDX-License-Identifier: GPL-3.0-or-later
// "WxDxH" and "X,Y,Z" of the command line.
#include <charconv>
#include <cmath>
#include <optional>

#include "core/zmap/stock.h"
#include "core/zmap/zmap_findings.h"

namespace proveout {

namespace {

/// Three finite numbers with `separator` (or its capital) between them; apart from that only spaces.
std::optional<Vec3> threeNumbers(std::string_view text, char separator, char capital) {
    Vec3 numbers{0};
    for (int i = 0; i < 3; ++i) {
        while (!text.empty() && text.front() == ' ')
            text.remove_prefix(1);
        // A leading plus is common in machine tool files, but from_chars does not accept it.
        if (text.size() > 1 && text.front() == '+' && text[1] != '-')
            text.remove_prefix(1);
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), numbers[i]);
        if (error != std::errc{} || !std::isfinite(numbers[i]))
            return {};
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
        while (!text.empty() && text.front() == ' ')
            text.remove_prefix(1);
        if (i == 2)
            break;
        if (text.empty() || (text.front() != separator && text.front() != capital))
            return {};
        text.remove_prefix(1);
    }
    return text.empty() ? std::optional(numbers) : std::nullopt;
}

} // namespace

Result<Vec3> parseStockSize(std::string_view text) {
    const auto size = threeNumbers(text, 'x', 'X');
    if (!size)
        return failure(zmap_finding::kStockSizeForm, {std::string(text), "140x100x30"});
    for (int axis = 0; axis < 3; ++axis) {
        if (!((*size)[axis] > 0))
            return failure(zmap_finding::kStockSizeNotPositive, {std::string(text)});
    }
    return *size;
}

Result<Vec3> parsePoint(std::string_view text) {
    const auto point = threeNumbers(text, ',', ',');
    if (!point)
        return failure(zmap_finding::kPointForm, {std::string(text)});
    return *point;
}

} // namespace proveout
