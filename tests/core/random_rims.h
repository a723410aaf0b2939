// SPDX-License-Identifier: GPL-3.0-or-later
// Rims of any kind on some of the edges of a map, and ribs on others.
#pragma once

#include <memory>
#include <random>

#include "core/zmap/rims.h"
#include "core/zmap/zmap.h"

namespace proveout {

inline RimTilePtr randomRims(std::mt19937& random, const ZMapSnapshot& map, std::size_t tile) {
    const IndexRect rect = map.tileRect(tile);
    std::uniform_real_distribution<float> height(map.floor(), 0);
    const auto normal = [&] { return static_cast<std::int16_t>(static_cast<int>(random() % 65535) - 32767); };
    RimTile rims;
    for (int index = 0; index < Tile::kSize * Tile::kSize * 2; ++index) {
        const RimEdge edge = RimEdge::of(static_cast<std::uint16_t>(index));
        const int i = rect.i0 + edge.i + (edge.alongY ? 0 : 1);
        const int j = rect.j0 + edge.j + (edge.alongY ? 1 : 0);
        if (edge.i >= rect.width() || edge.j >= rect.height() || i >= map.grid().nx || j >= map.grid().ny)
            continue;
        if (random() % 20 == 0)
            rims.unseenRibs.push_back(edge.index());
        if (random() % 5 != 0)
            continue;
        rims.rims.push_back({edge.index(), static_cast<std::uint16_t>(random()),
                             static_cast<std::uint16_t>(random()), static_cast<RimSides>(random() % 3),
                             height(random), height(random), normal(), normal()});
    }
    return rims.rims.empty() ? nullptr : std::make_shared<const RimTile>(std::move(rims));
}

/// Some tiles have none.
inline RimMap randomRims(std::mt19937& random, const ZMapSnapshot& map) {
    RimMap rims;
    for (std::size_t tile = 0; tile < map.tileCount(); ++tile)
        rims.push_back(random() % 4 == 0 ? nullptr : randomRims(random, map, tile));
    return rims;
}

inline bool sameRims(const RimMap& a, const RimMap& b) {
    if (a.size() != b.size())
        return false;
    for (std::size_t tile = 0; tile < a.size(); ++tile)
        if (a[tile] == nullptr || b[tile] == nullptr ? a[tile] != b[tile] : !(*a[tile] == *b[tile]))
            return false;
    return true;
}

} // namespace proveout
