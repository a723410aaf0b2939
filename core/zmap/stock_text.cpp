// SPDX-License-Identifier: GPL-3.0-or-later
// "WxDxH" and "X,Y,Z" of the command line.
#include <charconv>
#include <cmath>
#include <optional>

#include "core/base/text.h"
#include "core/zmap/stock.h"

namespace proveout {

namespace {

/// Three finite numbers with `separator` (or its capital) between them; nothing else but spaces.
std::optional<Vec3> threeNumbers(std::string_view text, char separator, char capital) {
    Vec3 numbers{0};
    for (int i = 0; i < 3; ++i) {
        while (!text.empty() && text.front() == ' ')
            text.remove_prefix(1);
        // A leading plus is common in machine tools' texts, but unknown to from_chars.
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
        return failure("stock-size-form",
                       PROVEOUT_TEXT("Core", "“{}” is not a stock size of the form WxDxH in mm, as in {}."),
                       {std::string(text), "140x100x30"});
    for (int axis = 0; axis < 3; ++axis) {
        if (!((*size)[axis] > 0))
            return failure("stock-size-not-positive",
                           PROVEOUT_TEXT("Core", "Every side of the stock must be more than 0 mm, not “{}”."),
                           {std::string(text)});
    }
    return *size;
}

Result<Vec3> parsePoint(std::string_view text) {
    const auto point = threeNumbers(text, ',', ',');
    if (!point)
        return failure("point-form", PROVEOUT_TEXT("Core", "“{}” is not a point of the form X,Y,Z in mm."),
                       {std::string(text)});
    return *point;
}

} // namespace proveout
