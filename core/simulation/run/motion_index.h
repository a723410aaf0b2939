// SPDX-License-Identifier: GPL-3.0-or-later
// Which motions may have cut where.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/cutting/cut/cutting.h"
#include "core/nc/program/program.h"

namespace proveout {

/// For each tile of a z-map the motions of a program that may lower it: its points, those one before them and
/// those two after them, along x and y, which its rims depend on. So two states of a stock after two
/// beginnings of a program are equal there if both have the same of these motions. Eight bytes per tile and
/// run of consecutive motions over it. Owned by one thread; others may read it meanwhile if it is not
/// changed.
class MotionIndex {
public:
    static constexpr int kPointsBefore = 1; ///< a tile
    static constexpr int kPointsAfter = 2;

    MotionIndex() = default; ///< of a map without tiles
    MotionIndex(const StockBox& stock, const Grid& grid);

    /// Adds the next motion of the program.
    void append(const CutterMotion& motion);
    /// Keeps the first `motions` motions.
    void truncate(std::size_t motions);
    [[nodiscard]] std::size_t motionCount() const { return m_motions; }

    /// Those over a tile among the first `motions` motions: ascending ranges that do not meet.
    [[nodiscard]] std::vector<Program::MotionRange> over(std::size_t tile, std::size_t motions) const;
    /// The end of the last of these ranges; 0 if there is none. Equal ends mean equal ranges.
    [[nodiscard]] std::size_t endOver(std::size_t tile, std::size_t motions) const;

    [[nodiscard]] std::size_t bytes() const; ///< allocated

private:
    struct Run { ///< of motions over a tile
        std::uint32_t first;
        std::uint32_t last;
    };
    /// The part of a path between two points over ground, from the corner of the grid.
    struct Piece {
        Vec2 from{0};
        Vec2 to{0};
        bool straight = true; ///< else anywhere in the box of the points
    };
    void append(const Piece& piece, double radius);
    void appendLine(const Motion& motion, double radius);
    void appendArc(const Motion& motion, double radius);
    void appendTo(std::size_t tile);

    Grid m_grid;
    double m_topZ = 0;
    int m_tilesX = 0;
    int m_tilesY = 0;
    std::size_t m_motions = 0;
    std::vector<std::vector<Run>> m_runs; ///< by tile
};

} // namespace proveout
