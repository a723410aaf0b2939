// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to this library.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/cutting/cut/cutting.h"
#include "core/cutting/cut/falling_edges.h"
#include "core/cutting/cut/plan_area.h"
#include "core/cutting/cut/sweep.h"
#include "core/zmap/rims.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// The motions near some edges of a tile, as sweeps, by squares of it. Owned by one thread.
class NearSweeps {
public:
    NearSweeps(const ZMapSnapshot& zmap, const IndexRect& tile, const std::vector<FallingEdge>& edges);

    /// Keeps the motion if it is near one of the edges.
    void add(const CutterMotion& motion);
    [[nodiscard]] bool isFull() const { return m_sweeps.size() > kMostMotionsOfRims; }
    /// Call it once, after the last motion.
    void sort();

    /// Those in an area near an edge, the lowest first.
    [[nodiscard]] std::vector<const Sweep*> over(const RimEdge& edge, const PlanArea& area);

private:
    static constexpr int kPoints = 8;
    static constexpr int kSquares = Tile::kSize / kPoints;
    struct Square {
        bool hasEdges = false;
        bool collected = false;
        std::vector<std::size_t> sweeps; ///< ascending, as are their lowest heights
    };

    [[nodiscard]] static std::size_t squareOf(const RimEdge& edge) {
        return static_cast<std::size_t>(edge.j / kPoints * kSquares + edge.i / kPoints);
    }
    /// Of its edges, which end at the first points of the next one.
    [[nodiscard]] PlanArea areaOf(std::size_t square) const;
    void collect(std::size_t square);

    const Grid& m_grid;
    double m_topZ;
    IndexRect m_tile;
    PlanArea m_area{};
    std::vector<Sweep> m_sweeps;
    std::array<Square, std::size_t{kSquares} * kSquares> m_squares;
    std::vector<std::size_t> m_withEdges; ///< squares
};

} // namespace proveout
