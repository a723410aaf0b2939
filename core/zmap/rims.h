// SPDX-License-Identifier: GPL-3.0-or-later
// Where between the points of a z-map a wall stands.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/persistent_array.h"

namespace proveout {

/// Parts of normals as rims hold them, in 32 767ths.
[[nodiscard]] inline std::int16_t inRimUnits(double part) {
    return static_cast<std::int16_t>(std::lround(std::clamp(part, -1.0, 1.0) * 32767));
}
[[nodiscard]] inline Vec2 normalInRimUnits(std::int16_t x, std::int16_t y) {
    return {x / 32767.0, y / 32767.0};
}

/// Which sides of a wall are known on an edge: the wall may go on beyond its other end.
enum class RimSides : std::uint8_t { both, high, low };

/// How far beyond a wall between levels the surface is measured for its lower end, as a part of the edge:
/// passes at several depths follow one outline within the rounding of the program.
inline constexpr double kRimBeyond = 1.0 / 64;

/// A slope begins or ends at a level where it is away from it by this part of an edge.
inline constexpr double kRimCrease = 1.0 / 1024;

/// A wall that crosses an edge of the grid: the line from a point to the next one along x or y.
struct Rim {
    std::uint16_t edge; ///< of its tile: RimEdge
    /// Where the wall begins on its high and on its low side, from the edge's first point, in 65 536ths of
    /// the edge: the same place if it is vertical.
    std::uint16_t highPlace;
    std::uint16_t lowPlace;
    RimSides sides;
    float top; ///< heights at both ends of the wall, relative to the top of the stock, mm
    float bottom;
    std::int16_t normalX; ///< of the wall over ground, from its low to its high side
    std::int16_t normalY;

    [[nodiscard]] bool has(bool high) const {
        return sides == RimSides::both || high == (sides == RimSides::high);
    }
    [[nodiscard]] bool isUpright() const { return sides == RimSides::both && highPlace == lowPlace; }
    [[nodiscard]] double fraction(bool high) const { return (high ? highPlace : lowPlace) / 65536.0; }
    [[nodiscard]] Vec2 normal() const { return normalInRimUnits(normalX, normalY); }
    friend bool operator==(const Rim&, const Rim&) = default;
};

/// An edge of a tile, by its first point within the tile and its direction. A tile has the edges whose first
/// point is its own; the last of a row ends at the first point of the next tile.
struct RimEdge {
    int i;
    int j;
    bool alongY;

    [[nodiscard]] std::uint16_t index() const {
        return static_cast<std::uint16_t>((j * 64 + i) * 2 + alongY);
    }
    [[nodiscard]] static RimEdge of(std::uint16_t index) {
        return {index / 2 % 64, index / 128, index % 2 != 0};
    }
};

/// More motions near the walls of a tile take too long, and too much memory.
inline constexpr std::size_t kMostMotionsOfRims = 32'768;

/// The rims of a tile, by ascending edges. Immutable once published.
struct RimTile {
    std::vector<Rim> rims;
    /// Some or all are missing: too many motions are near its walls, or walls of the stock are not known.
    bool areUnknown = false;
    /// RimEdge::index() of the edges, ascending, that a rib crosses unseen: it stands on a level floor
    /// between their two points, which are on the floor.
    std::vector<std::uint16_t> unseenRibs = {};

    [[nodiscard]] bool empty() const { return rims.empty() && !areUnknown && unseenRibs.empty(); }
    /// Null: there is no rim on that edge.
    [[nodiscard]] const Rim* find(const RimEdge& edge) const {
        const auto found = std::ranges::lower_bound(rims, edge.index(), {}, &Rim::edge);
        return found != rims.end() && found->edge == edge.index() ? &*found : nullptr;
    }
    friend bool operator==(const RimTile&, const RimTile&) = default;
};
using RimTilePtr = std::shared_ptr<const RimTile>;

/// Per tile of a z-map; null: no rim, nor an unseen rib. Empty: rims are not known. Equal pointers mean equal
/// rims.
using RimMap = PersistentArray<RimTilePtr>;

/// Rims of which none is known, for so many tiles.
[[nodiscard]] inline RimMap unknownRims(std::size_t tiles) {
    return RimMap(tiles, std::make_shared<const RimTile>(RimTile{{}, true}));
}

/// The number of tiles of which some rims are not known.
[[nodiscard]] inline std::size_t unknownTiles(const RimMap& rims) {
    std::size_t count = 0;
    for (std::size_t tile = 0; tile < rims.size(); ++tile)
        count += rims[tile] != nullptr && rims[tile]->areUnknown ? 1 : 0;
    return count;
}

/// Whether there is a rim, a rib, or a tile whose rims are not known.
[[nodiscard]] inline bool hasAny(const RimMap& rims) {
    for (std::size_t tile = 0; tile < rims.size(); ++tile)
        if (rims[tile] != nullptr && !rims[tile]->empty())
            return true;
    return false;
}

/// The number of edges that ribs cross unseen.
[[nodiscard]] inline std::size_t unseenRibs(const RimMap& rims) {
    std::size_t count = 0;
    for (std::size_t tile = 0; tile < rims.size(); ++tile)
        count += rims[tile] == nullptr ? 0 : rims[tile]->unseenRibs.size();
    return count;
}

/// The number of rims in all tiles.
[[nodiscard]] inline std::size_t countOf(const RimMap& rims) {
    std::size_t count = 0;
    for (std::size_t tile = 0; tile < rims.size(); ++tile)
        count += rims[tile] == nullptr ? 0 : rims[tile]->rims.size();
    return count;
}

} // namespace proveout
