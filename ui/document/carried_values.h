// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/decimation/regions/parameters.h"
#include "core/simulation/setup/setup.h"

namespace proveout {

/// Which of the differences are applied.
enum class Carry : std::uint8_t {
    all,
    whereSame, ///< only those where `now` still equals `from`
};

/// Applies the differences between `from` and `to` to `now` and leaves everything else unchanged: field by
/// field, fixture by fixture, tool by tool, and the sizes of a box one by one. The spacing of an automatic
/// grid is not applied, because it follows from stock and cutters.
[[nodiscard]] Setup carried(Setup now, const Setup& from, const Setup& to, Carry which = Carry::all);
/// The same for the parameters; all differences are applied.
[[nodiscard]] DecimationParameters carried(DecimationParameters now, const DecimationParameters& from,
                                           const DecimationParameters& to);

} // namespace proveout
