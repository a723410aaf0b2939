// SPDX-License-Identifier: GPL-3.0-or-later
// Ribs that stand between two points of a map, so that its heights say nothing of them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/geometry.h"
#include "core/cutting/cut/cutting.h"
#include "core/cutting/cut/flat_pass.h"
#include "core/cutting/cut/plan_area.h"
#include "core/zmap/rims.h"
#include "core/zmap/stock_shape.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// Finds the edges of a tile between level floors that a rib crosses: flat cutters, or any that went below
/// the floor of the stock, passed over both ends on level motions, but leave a gap between them. Call add()
/// for each motion that may reach the tile, then suspects(); if there are some, lower() for each motion
/// again, and then edges(). Thinner than a ten-thousandth of a millimetre, or less than an eighth of an edge
/// above the higher floor, nothing counts as a rib. Ribs that the stock had remain where motions leave
/// anything at some of 33 places of the edge. Refers to the map. Owned by one thread; the result is the same
/// for any order of the motions.
class UnseenRibs {
public:
    /// `ofStock`: what the stock knows of the tile (StockTop::rims()), whose unseen ribs count; null:
    /// nothing.
    UnseenRibs(const ZMapSnapshot& zmap, std::size_t tile, const RimTile* ofStock = nullptr);

    /// Whether there are none, whatever was cut: the tile has no level floor, and the stock had none.
    [[nodiscard]] bool hasNone() const { return m_floors.empty() && m_count == 0; }
    void add(const CutterMotion& motion);
    /// Whether some edges may have ribs. `uncut`: the top of the stock; null: the whole box.
    [[nodiscard]] bool suspects(const StockTop* uncut);
    void lower(const CutterMotion& motion);
    /// RimEdge::index() of those with ribs, ascending.
    [[nodiscard]] std::vector<std::uint16_t> edges() const;

private:
    using Row = FlatPass::Row;
    using Rows = std::vector<Row>;
    static constexpr int kSide = Tile::kSize + 1; ///< points of the tile, and the next one
    static constexpr int kPoints = 8;             ///< of a square
    static constexpr int kSquares = Tile::kSize / kPoints;

    struct PartOfPass {
        std::uint32_t pass;
        std::uint32_t part;
    };
    /// In lists by squares of points, of the tile and the next ones.
    template<class Value>
    using BySquare = std::array<std::vector<Value>, std::size_t{kSquares} * kSquares>;

    struct Floor {
        double height = 0; ///< relative to the top of the stock, mm
        Rows points = Rows(kSide);
        Rows coveredX = Rows(kSide); ///< the edges that one of its passes covers, by their first points
        Rows coveredY = Rows(kSide);
        std::vector<FlatPass> passes = {};
        BySquare<PartOfPass> parts = {};
    };
    struct Suspect {
        RimEdge edge;
        double floor;
        Vec2 place;
        double height; ///< of what stands there
    };

    void addRibOfStock(const RimEdge& edge);
    /// By its first point.
    void addCell(int i, int j, double height);
    [[nodiscard]] std::optional<std::size_t> floorAt(double height) const;
    /// The highest floor that a point of the tile, or the next one, is on. Null: none.
    [[nodiscard]] const Floor* floorOf(int i, int j) const;
    void suspectRow(int j, bool alongY, const StockTop* uncut);
    void cover(Floor& floor, const FlatPass& pass) const;
    void suspect(const Floor& floor, const RimEdge& edge, const StockTop* uncut);
    /// The other point of an edge.
    [[nodiscard]] Vec2 endOf(const RimEdge& edge) const;
    [[nodiscard]] static std::size_t squareOf(const RimEdge& edge) {
        return static_cast<std::size_t>(edge.j / kPoints * kSquares + edge.i / kPoints);
    }
    /// Calls `visit(square)` for the squares whose edges an area may meet.
    template<class Visit>
    void eachSquare(const PlanArea& area, const Visit& visit) const;
    [[nodiscard]] Vec2 placeOf(int i, int j) const;

    /// Whether it may have been cut on one of the floors near the tile: a quick test.
    [[nodiscard]] bool mayBeOnFloor(const Motion& motion) const;

    const ZMapSnapshot& m_zmap;
    IndexRect m_tile;
    const RimTile* m_ofStock;
    double m_topZ;
    const Cutter* m_cutter = nullptr; ///< of the last motion
    std::optional<CutterEnd> m_end;   ///< its end
    std::vector<Floor> m_floors;
    std::size_t m_count = 0; ///< of suspects
    BySquare<Suspect> m_suspects;
};

} // namespace proveout
