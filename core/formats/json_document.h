// SPDX-License-Identifier: GPL-3.0-or-later
// Parses JSON from a text that may be hostile, with the places of its fields. Internal to this library.
#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/diagnostic.h"

namespace proveout {

/// Where a field is in the text, and what its value is.
struct JsonPlace {
    TextRange where;                ///< of its name
    std::size_t object = kNoObject; ///< number of the object that is its value, if it is one

    static constexpr std::size_t kNoObject = std::numeric_limits<std::size_t>::max();
};

/// The places of the fields of all objects, except within arrays. Objects are numbered in the order in which
/// they begin; the outermost one is 0. Of fields with the same name the last counts, as in the JSON.
using JsonPlaces = std::map<std::pair<std::size_t, std::string>, JsonPlace>;

struct JsonDocument {
    nlohmann::json root;
    JsonPlaces places;
};

/// Parses JSON. Errors have line and column: syntax, numbers out of range, more than `depth` levels of
/// brackets.
[[nodiscard]] Result<JsonDocument> parseJson(std::string_view text, int depth);

} // namespace proveout
