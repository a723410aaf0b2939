// SPDX-License-Identifier: GPL-3.0-or-later
// The random programs that tests of forecasts use, by method.
#pragma once

#include <cstdint>
#include <vector>

#include "core/decimation/regions/parameters.h"
#include "tests/random_seed.h"

namespace proveout {

struct Rehearsed {
    DecimationMethod method;
    std::uint_fast32_t seed;
};

/// `all` programs from the seed `first`, or the share of them that this build runs.
inline std::vector<Rehearsed> rehearsed(DecimationMethod method, std::uint_fast32_t first, int all) {
    std::vector<Rehearsed> some;
    for (int k = 0; k < roundsOf(all); ++k)
        some.push_back({method, first + static_cast<std::uint_fast32_t>(k)});
    return some;
}

} // namespace proveout
