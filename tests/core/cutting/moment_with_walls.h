// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "core/cutting/cut/tile_rims.h"
#include "core/zmap/wall_points.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// A map of a box after exactly these motions, with its walls.
[[nodiscard]] inline ZMapSnapshot withWalls(ZMapSnapshot moment, const std::vector<CutterMotion>& motions) {
    RimMap rims;
    for (std::size_t tile = 0; tile < moment.tileCount(); ++tile)
        rims.push_back(rimsOfTile(moment, tile, nullptr, motions, {}, RimEdges::atLevels));
    moment.setRims(std::move(rims));
    moment.setWalls(WallPoints(moment));
    return moment;
}

} // namespace proveout
