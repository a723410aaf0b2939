// SPDX-License-Identifier: GPL-3.0-or-later
// The z-map: heights of the stock at the points of a grid.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/base/index_rect.h"
#include "core/base/persistent_array.h"
#include "core/zmap/rims.h"
#include "core/zmap/stock.h"
#include "core/zmap/wall_points.h"

namespace proveout {

/// A square of 64 × 64 heights, row by row, contiguous. Points outside the grid hold `floor`.
struct Tile {
    static constexpr int kSize = 64;
    /// Cutting works on blocks of 16 × 16 points; a tile has 4 × 4 of them, counted row by row.
    static constexpr int kBlockSize = 16;
    static constexpr int kBlocks = kSize / kBlockSize;

    std::array<float, std::size_t{kSize} * kSize> heights;
    std::array<float, std::size_t{kBlocks} * kBlocks>
        blockMaxima{};               ///< upper bounds of the heights of each block
    float maximum = 0;               ///< an upper bound of all heights: the largest of the blocks'
    std::uint32_t loweredPoints = 0; ///< since refreshMaximum(); lets the writer decide when another call
                                     ///< pays

    [[nodiscard]] float& at(int i, int j) { return heights[static_cast<std::size_t>(j * kSize + i)]; }
    [[nodiscard]] float at(int i, int j) const { return heights[static_cast<std::size_t>(j * kSize + i)]; }
    void refreshMaximum(); ///< makes all bounds exact
    void updateMaximum();  ///< from those of the blocks
};

/// The number of tiles over a grid.
[[nodiscard]] std::size_t tileCountOf(const Grid& grid);

/// The grid points of tile `index`, tiles counted row by row.
[[nodiscard]] IndexRect tileRectOf(const Grid& grid, std::size_t index);

/// An immutable snapshot of a z-map; any thread. Heights are relative to the stock's top (0 uncut, floor() =
/// -height at the stock's floor), so that float precision does not depend on the position of Z0. Equal tile
/// pointers of two snapshots mean equal heights: that is how viewers find what to upload again.
class ZMapSnapshot {
public:
    ZMapSnapshot() = default;
    ZMapSnapshot(StockBox stock, Grid grid, PersistentArray<std::shared_ptr<const Tile>> tiles);

    [[nodiscard]] const StockBox& stock() const { return m_stock; }
    [[nodiscard]] const Grid& grid() const { return m_grid; }
    [[nodiscard]] float floor() const { return static_cast<float>(-m_stock.height); }
    [[nodiscard]] int tilesX() const { return (m_grid.nx + Tile::kSize - 1) / Tile::kSize; }
    [[nodiscard]] int tilesY() const { return (m_grid.ny + Tile::kSize - 1) / Tile::kSize; }
    [[nodiscard]] std::size_t tileCount() const { return m_tiles.size(); }
    [[nodiscard]] const std::shared_ptr<const Tile>& tile(std::size_t index) const { return m_tiles[index]; }
    /// The grid points of tile `index`.
    [[nodiscard]] IndexRect tileRect(std::size_t index) const;

    [[nodiscard]] float height(int i, int j) const {
        const auto tile = static_cast<std::size_t>((j / Tile::kSize) * tilesX() + i / Tile::kSize);
        return m_tiles[tile]->at(i % Tile::kSize, j % Tile::kSize);
    }
    /// Where walls stand between the points, and the points beside them; empty where nobody asked for them.
    [[nodiscard]] const RimMap& rims() const { return m_rims; }
    [[nodiscard]] const WallPoints& walls() const { return m_walls; }
    void setRims(RimMap rims) { m_rims = std::move(rims); }
    void setWalls(WallPoints walls) { m_walls = std::move(walls); }

    /// Copies the heights of a rectangle, row by row, to `out` (width × height values).
    void read(const IndexRect& rect, std::span<float> out) const;
    /// Whether two snapshots of one grid have the same heights in a rectangle.
    [[nodiscard]] bool sameHeights(const ZMapSnapshot& other, const IndexRect& rect) const;
    /// Volume of the remaining stock, mm³: the integral over cells of the mean of their corners.
    [[nodiscard]] double volume() const;

private:
    friend class ZMap;

    StockBox m_stock;
    Grid m_grid;
    PersistentArray<std::shared_ptr<const Tile>> m_tiles;
    RimMap m_rims;
    WallPoints m_walls;
};

/// The z-map that is being cut. Owned by one thread; parallel work may write different tiles at once after
/// `tileForWriting` was called for each. Movable, not copyable: both copies would assume that they own their
/// tiles; to continue elsewhere, construct a map from a `snapshot()`.
class ZMap {
public:
    ZMap() = default;
    ZMap(const ZMap&) = delete;
    ZMap(ZMap&&) noexcept = default;
    ZMap& operator=(const ZMap&) = delete;
    ZMap& operator=(ZMap&&) noexcept = default;
    ~ZMap() = default;
    /// Uncut stock. Each tile that is written then takes memory of its own; ask checkMemory() first.
    ZMap(const StockBox& stock, const Grid& grid);
    /// Continues from a snapshot.
    explicit ZMap(const ZMapSnapshot& moment);

    [[nodiscard]] const StockBox& stock() const { return m_stock; }
    [[nodiscard]] const Grid& grid() const { return m_grid; }
    [[nodiscard]] float floor() const { return static_cast<float>(-m_stock.height); }
    [[nodiscard]] int tilesX() const { return (m_grid.nx + Tile::kSize - 1) / Tile::kSize; }
    [[nodiscard]] int tilesY() const { return (m_grid.ny + Tile::kSize - 1) / Tile::kSize; }
    [[nodiscard]] std::size_t tileCount() const { return m_tiles.size(); }
    [[nodiscard]] const Tile& tile(std::size_t index) const { return *m_tiles[index]; }
    /// The grid points of tile `index`.
    [[nodiscard]] IndexRect tileRect(std::size_t index) const;
    /// Copies the tile first if a snapshot shares it, or other uncut tiles.
    [[nodiscard]] Tile& tileForWriting(std::size_t index);
    /// The tile if nothing shares it, else nullptr: then a worker makes its own copy and passes it to
    /// `adoptTile` on the owner's thread once it knows that heights have changed.
    [[nodiscard]] Tile* ownedTile(std::size_t index);
    /// Replaces a shared tile.
    void adoptTile(std::size_t index, std::shared_ptr<Tile> tile);

    /// A snapshot of the current heights; costs a pointer per 256 tiles, and one tile copy per tile written
    /// afterwards.
    [[nodiscard]] ZMapSnapshot snapshot() const;

private:
    StockBox m_stock;
    Grid m_grid;
    PersistentArray<std::shared_ptr<const Tile>> m_tiles;
    std::vector<std::uint32_t> m_writtenIn; ///< per tile: the generation in which it became ours
    mutable std::uint32_t m_generation = 1; ///< rises with each snapshot
};

} // namespace proveout
