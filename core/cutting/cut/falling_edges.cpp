// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/cut/falling_edges.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "core/cutting/profiles/vector_clones.h"

namespace proveout {

namespace {

/// The heights of a tile with one point before it and two after it on each side. Outside the map, the first
/// edge falls as the second one within it, and the others do not.
class Surroundings {
public:
    static constexpr int kSide = Tile::kSize + 3;

    Surroundings(const ZMapSnapshot& zmap, const IndexRect& tile) {
        const Grid& grid = zmap.grid();
        const IndexRect known =
            intersection({tile.i0 - 1, tile.j0 - 1, tile.i1 + 2, tile.j1 + 2}, {0, 0, grid.nx, grid.ny});
        std::array<float, std::size_t{kSide} * kSide> read;
        zmap.read(known, read);
        const IndexRect within{known.i0 - (tile.i0 - 1), known.j0 - (tile.j0 - 1), known.i1 - (tile.i0 - 1),
                               known.j1 - (tile.j0 - 1)};
        for (int j = 0; j < kSide; ++j) {
            const int row = std::clamp(j, within.j0, within.j1 - 1) - within.j0;
            const float* from = read.data() + std::ptrdiff_t{row} * known.width();
            float* to = m_heights.data() + std::ptrdiff_t{j} * kSide;
            std::fill_n(to, within.i0, from[0]);
            std::copy_n(from, known.width(), to + within.i0);
            std::fill(to + within.i1, to + kSide, from[known.width() - 1]);
            continueBeyond(to, 1, within.i0, within.i1);
        }
        for (int i = 0; i < kSide; ++i)
            continueBeyond(m_heights.data() + i, kSide, within.j0, within.j1);
    }

    /// The height of a point of the tile.
    [[nodiscard]] const float* at(int i, int j) const {
        return m_heights.data() + std::ptrdiff_t{j + 1} * kSide + (i + 1);
    }

private:
    /// Of a row or column whose heights from `begin` to `end` are known.
    static void continueBeyond(float* heights, std::ptrdiff_t step, int begin, int end) {
        if (begin > 0)
            heights[0] = heights[step] + (heights[2 * step] - heights[3 * step]);
        if (end >= 3 && end < kSide) {
            float* after = heights + end * step;
            *after = after[-step] + (after[-2 * step] - after[-3 * step]);
        }
    }

    std::array<float, std::size_t{kSide} * kSide> m_heights;
};

using RowMarks = std::array<std::uint32_t, Tile::kSize>;

/// What is looked for along one axis; falls of edges, mm.
struct Wanted {
    float least;
    float most;  ///< of the edges before and after it
    float level; ///< or of one of them; negative: none

    /// `height`: of the stock, mm.
    Wanted(RimEdges edges, double spacing, double height)
        : least(static_cast<float>(kWallSlope * spacing)),
          most(edges == RimEdges::all ? std::numeric_limits<float>::infinity() : least),
          level(edges != RimEdges::atLevels
                    ? -1.0F
                    : static_cast<float>(kLevelSlope * spacing + kLevelRounding * height)) {}
};

/// Falls at levels count so many times as much.
constexpr float kCreasesAlso = kWallSlope / kCreaseSlope;

/// Marks the edges from each of the points of a row to the next one `step` heights on that are wanted.
/// Returns whether there is one.
PROVEOUT_VECTOR_CLONES bool markRow(const float* row, std::ptrdiff_t step, const Wanted& wanted,
                                    RowMarks& marks) {
    const float most = wanted.most;
    const float level = wanted.level;
    const float least = wanted.least;
    const float* last = row - step;
    const float* next = row + step;
    const float* afterNext = next + step;
    std::array<float, Tile::kSize> excess;
    for (std::size_t i = 0; i < Tile::kSize; ++i) {
        const float before = last[i] - row[i];
        const float fall = row[i] - next[i];
        const float after = next[i] - afterNext[i];
        const float highest = before > after ? before : after;
        const float lowest = before < after ? before : after;
        const float flatBefore = before > 0 ? before : -before;
        const float flatAfter = after > 0 ? after : -after;
        const float down = highest <= most ? fall - (before > 0 ? before : 0) : 0;
        const float up = lowest >= -most ? (after < 0 ? after : 0) - fall : 0;
        const float steep = fall > 0 ? fall : -fall;
        const float atLevel = flatBefore <= level || flatAfter <= level ? steep * kCreasesAlso : 0;
        const float wall = down > up ? down : up;
        excess[i] = wall > atLevel ? wall : atLevel;
    }
    std::uint32_t any = 0;
    for (std::size_t i = 0; i < Tile::kSize; ++i) {
        marks[i] = excess[i] > least ? 1 : 0;
        any |= marks[i];
    }
    return any != 0;
}

FallingEdge edgeAt(const float* point, std::ptrdiff_t step, const RimEdge& edge) {
    const bool reversed = point[0] < point[step];
    const float* high = reversed ? point + step : point;
    const std::ptrdiff_t onwards = reversed ? -step : step;
    return {edge,
            reversed,
            double{high[0]},
            double{high[onwards]},
            double{high[-onwards]} - double{high[0]},
            double{high[onwards]} - double{high[2 * onwards]}};
}

} // namespace

std::vector<FallingEdge> fallingEdges(const ZMapSnapshot& zmap, std::size_t tile, RimEdges wanted) {
    const IndexRect rect = zmap.tileRect(tile);
    const Grid& grid = zmap.grid();
    const Surroundings heights(zmap, rect);
    std::vector<FallingEdge> edges;
    RowMarks alongX;
    RowMarks alongY;
    const Wanted wantedX(wanted, grid.hx, zmap.stock().height);
    const Wanted wantedY(wanted, grid.hy, zmap.stock().height);
    const int edgesX = std::min(rect.width(), grid.nx - 1 - rect.i0);
    const int edgesY = std::min(rect.height(), grid.ny - 1 - rect.j0);
    for (int j = 0; j < rect.height(); ++j) {
        const float* row = heights.at(0, j);
        const bool anyX = markRow(row, 1, wantedX, alongX);
        const bool anyY = markRow(row, Surroundings::kSide, wantedY, alongY);
        if (!anyX && !anyY)
            continue;
        for (int i = 0; i < rect.width(); ++i) {
            if (i < edgesX && alongX[static_cast<std::size_t>(i)] != 0)
                edges.push_back(edgeAt(row + i, 1, {i, j, false}));
            if (j < edgesY && alongY[static_cast<std::size_t>(i)] != 0)
                edges.push_back(edgeAt(row + i, Surroundings::kSide, {i, j, true}));
        }
    }
    return edges;
}

} // namespace proveout
