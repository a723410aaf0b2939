// SPDX-License-Identifier: GPL-3.0-or-later
// The inner loop of cutting: one straight motion over a block of 16 × 16 points, in vectors of whatever width
// the processor has.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/zmap/zmap.h"

namespace proveout {

/// One straight motion of one convex profile seen from a square of points, in single precision, lengths
/// in mm, heights from the top of the stock. The origin along the path is chosen near the points, so that
/// every number is as small as the cutter and the square and digits do not depend on where they lie. A point
/// at column i, row j lies `along` + i·`alongX` + j·`alongY` on the path's line and `across` + … beside it.
struct BlockPass {
    enum class Form : std::uint8_t { flat, line, ball, corner };

    Form form = Form::flat;
    bool level = false; ///< nowhere rising or falling: what is nearest is lowest
    float along = 0;
    float alongX = 0;
    float alongY = 0;
    float across = 0;
    float acrossX = 0;
    float acrossY = 0;
    float begin = 0; ///< of the path, along
    float end = 0;
    float z = 0; ///< of the profile's reference (the centre of its arc, else its lowest place) at along = 0
    float slope = 0;
    float rim2 = 0;   ///< points no farther are under the cutter; squares of lengths
    float flatTo = 0; ///< line and corner: the radius at which the flat ends
    float rise = 0;   ///< line: mm per mm
    float ring = 0;   ///< corner: the radius of its arc's centre
    float radius = 0; ///< ball and corner: of the arc
    float lead = 0; ///< ball: how far ahead it stands, by the height of its surface; line: the square of the
                    ///< same by the distance across; negative: it stands at the rim
};

/// What a pass leaves of a block of 16 × 16 points.
struct BlockHeights {
    static constexpr int kSize = Tile::kBlockSize;

    alignas(64) std::array<float, std::size_t{kSize} * kSize> heights; ///< row by row
    std::array<std::uint16_t, kSize> lowered; ///< a bit a column: whether the point became lower
    std::uint32_t rows = 0;                   ///< a bit a row: whether any of its points did
    float maximum = 0;                        ///< of all heights
};

/// The minimum of the heights of a block and the envelope of the pass, nowhere below `floor`. `heights`: the
/// first point of the block, rows `stride` apart; they may be those of `result`. Any thread. The same bits on
/// every processor and for every width of vectors.
void lowerBlock(const BlockPass& pass, const float* heights, std::size_t stride, float floor,
                BlockHeights& result);

/// What the rows of a block lost.
struct BlockLoss {
    double sum = 0;  ///< of heights, in an order that does not depend on the width of vectors
    float depth = 0; ///< the largest
};

/// Puts the rows of `block` whose bits are set into the place of those at `heights`, which are Tile::kSize
/// apart and nowhere lower.
[[nodiscard]] BlockLoss putRows(const BlockHeights& block, std::uint32_t rows, float* heights);

/// The blocks of a tile, a bit each, that a pass may lower: of all others its envelope is above the maximum.
/// `pass` is seen from the first block's middle, its columns and rows are blocks, and its profile is dilated
/// by what lies between a block's middle and its corners.
[[nodiscard]] std::uint32_t blocksBelow(const BlockPass& pass, const float* maxima, float slack);

} // namespace proveout
