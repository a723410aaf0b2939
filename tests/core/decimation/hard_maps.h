// SPDX-License-Identifier: GPL-3.0-or-later
// Random height fields on which decimators have failed or might fail.
#pragma once

#include <cstdint>
#include <string>

#include "tests/core/decimation/maps.h"

namespace proveout::test {

struct HardMap {
    std::string kind;
    int nx = 2;
    int ny = 2;
    double spacing = 1; ///< mm, 0.01 to 2
    Heights heights;
};

/// Terrain, steps, spikes, needles, walls, noise, a constant, a tilted plane, or huge heights, with up to
/// `most` points along a side. Equal seeds give equal maps.
HardMap hardMap(std::uint32_t seed, int most);

} // namespace proveout::test
