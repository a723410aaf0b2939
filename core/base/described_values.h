// SPDX-License-Identifier: GPL-3.0-or-later
// Reads `key=value,…` into a struct of numbers by its descriptions (field.h).
#pragma once

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/field.h"
#include "core/base/figures_argument.h"
#include "core/base/finding_row.h"

namespace proveout {

/// The findings of a struct: a value that is not a number or is out of range {key, minimum, maximum}, and an
/// unknown key {key, all keys}.
struct DescribedFindings {
    const FindingRow& value;
    const FindingRow& key;
};

/// Sets one field from its text.
template<class Described>
[[nodiscard]] Result<void> setDescribed(Described& values, std::string_view key, std::string_view text,
                                        const DescribedFindings& findings) {
    std::string keys;
    Result<void> result;
    bool known = false;
    describe(values, [&](double& value, const Field& field) {
        keys += (keys.empty() ? "" : ", ") + std::string(field.key);
        if (key != field.key)
            return;
        known = true;
        double number = 0;
        const char* end = text.data() + text.size();
        const auto [read, error] = std::from_chars(text.data(), end, number);
        if (error == std::errc() && read == end && isInRange(field, number))
            value = number;
        else
            result = failure(findings.value,
                             {std::string(key), figures("{}", field.minimum), figures("{}", field.maximum)});
    });
    if (!known)
        return failure(findings.key, {std::string(key), keys});
    return result;
}

/// Sets the fields that are named, separated by commas; the others keep their values.
template<class Described>
[[nodiscard]] Result<Described> parseDescribed(std::string_view text, Described values,
                                               const DescribedFindings& findings) {
    while (!text.empty()) {
        const std::string_view item = text.substr(0, text.find(','));
        text.remove_prefix(std::min(text.size(), item.size() + 1));
        const std::size_t sign = item.find('=');
        const std::string_view value =
            sign == std::string_view::npos ? std::string_view() : item.substr(sign + 1);
        if (auto set = setDescribed(values, item.substr(0, sign), value, findings); !set)
            return tl::unexpected(std::move(set.error()));
    }
    return values;
}

/// A text that ends in "file=NAME", whose name may hold any characters.
struct ValuesWithFile {
    std::string_view values; ///< before it, without the comma
    std::string_view file;
};
/// Nothing if it has no file, or one without a name.
[[nodiscard]] std::optional<ValuesWithFile> valuesBeforeFile(std::string_view text);

} // namespace proveout
