// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/decimation/regions/parameters.h"
#include "core/simulation/setup/setup.h"

namespace proveout {

/// Which of the differences are carried.
enum class Carry : std::uint8_t {
    all,
    whereSame, ///< only those in which the third setup is like `from`
};

/// Brings what differs between `from` and `to` into `now`, and leaves all else as it is there: field by
/// field, tool by tool, and the sizes of a box one by one. The spacing of an automatic grid is not carried,
/// because it follows stock and cutters.
[[nodiscard]] Setup carried(Setup now, const Setup& from, const Setup& to, Carry which = Carry::all);
/// The same of the parameters, which all are carried.
[[nodiscard]] DecimationParameters carried(DecimationParameters now, const DecimationParameters& from,
                                           const DecimationParameters& to);

} // namespace proveout
