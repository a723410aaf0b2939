// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

namespace proveout {

/// Which of `names` a misspelt `word` was probably meant to be: the one with the fewest letters mistyped,
/// missing, added or swapped with their neighbour (restricted Damerau-Levenshtein distance; capitals count as
/// small letters), at most a third of the letters. Empty where none is so near. Pure function; the view is
/// one of `names`.
[[nodiscard]] std::string_view nearestName(std::string_view word, std::span<const std::string_view> names);

} // namespace proveout
