// SPDX-License-Identifier: GPL-3.0-or-later
// Height fields for the tests of decimation.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/decimation/regions/parameters.h"
#include "core/zmap/zmap.h"

namespace proveout::test {

/// Heights, mm, at the points of a grid of nx × ny points, row by row.
using Heights = std::vector<float>;

struct MapKind {
    std::string name;
    std::function<Heights(int nx, int ny, double spacing, std::uint32_t seed)> make;
};

/// Flat, random terrain, walls and steps, spheres, noise.
std::span<const MapKind> mapKinds();
const MapKind& mapKind(const std::string& name);

/// A z-map with these heights, which must be within [-100, 0].
ZMapSnapshot zmapOf(int nx, int ny, double spacing, const Heights& heights);

/// The certified method.
inline DecimationParameters certifiedParameters(int region, double allowance, ErrorLevel level) {
    DecimationParameters parameters;
    parameters.method = DecimationMethod::certified;
    parameters.regionCells = region;
    parameters.allowance = allowance;
    parameters.level = level;
    return parameters;
}

/// The paper's method with the paper's region size, certified.
inline DecimationParameters leeParameters() {
    DecimationParameters parameters;
    parameters.method = DecimationMethod::lee;
    parameters.regionCells = 8;
    return parameters;
}

} // namespace proveout::test
