// SPDX-License-Identifier: GPL-3.0-or-later
// The points of a block of a tile, as vectors. Compiled once per instruction set.
#if defined(PROVEOUT_CUTTING_BLOCK_PLACES) == defined(HWY_TARGET_TOGGLE)
#ifdef PROVEOUT_CUTTING_BLOCK_PLACES
#undef PROVEOUT_CUTTING_BLOCK_PLACES
#else
#define PROVEOUT_CUTTING_BLOCK_PLACES
#endif

#include <limits>

#include "core/cutting/kernels/pass_envelope-inl.h"

HWY_BEFORE_NAMESPACE();
namespace proveout {
namespace HWY_NAMESPACE {
namespace {

inline constexpr std::size_t kBlock = TileUnderWork::kBlock;
inline constexpr std::size_t kBlocks = TileUnderWork::kBlocks;
inline constexpr std::size_t kGroups = TileUnderWork::kGroups;
inline constexpr std::size_t kGroupRows = TileUnderWork::kGroupRows;
inline constexpr float kTileMiddle = (Tile::kSize - 1) / 2.0F;
inline constexpr float kInfinity = std::numeric_limits<float>::infinity();

inline constexpr std::size_t kLanes =
    hn::MaxLanes(kFloats);                               ///< no supported target has vectors of unknown width
inline constexpr std::size_t kVectors = kBlock / kLanes; ///< per row of a block

/// Of a block, one bit for each strip: one vector in the four rows of a group. The vectors of a group follow
/// each other.
inline constexpr std::uint64_t kAllStrips = ~std::uint64_t{0} >> (64 - kGroups * kVectors);

HWY_INLINE bool any(M mask) {
    return !hn::AllFalse(kFloats, mask);
}

// The first point of a block, relative to the tile's first.
constexpr std::size_t columnOf(std::size_t block) {
    return block % Tile::kBlocks * kBlock;
}
constexpr std::size_t rowOf(std::size_t block) {
    return block / Tile::kBlocks * kBlock;
}
inline constexpr float kBlockMiddle = (TileUnderWork::kBlock - 1) / 2.0F;

/// The middle of a block, relative to the tile's middle.
struct BlockMiddle {
    float column;
    float row;
    explicit BlockMiddle(std::size_t block)
        : column(static_cast<float>(columnOf(block)) + kBlockMiddle - kTileMiddle),
          row(static_cast<float>(rowOf(block)) + kBlockMiddle - kTileMiddle) {}
};

/// Positions of the points of a block along and across a path.
struct BlockPlaces {
    V alongColumns[kVectors];
    V acrossColumns[kVectors];
    float along, across, alongY, acrossY;
    float row;

    HWY_INLINE BlockPlaces(const TilePass& pass, std::size_t block)
        : along(pass.along), across(pass.across), alongY(pass.alongY), acrossY(pass.acrossY),
          row(static_cast<float>(rowOf(block)) - kTileMiddle) {
        const float first = static_cast<float>(columnOf(block)) - kTileMiddle;
        for (std::size_t k = 0; k < kVectors; ++k) {
            const V columns = hn::Iota(kFloats, first + static_cast<float>(k * kLanes));
            alongColumns[k] = hn::Mul(all(pass.alongX), columns);
            acrossColumns[k] = hn::Mul(all(pass.acrossX), columns);
        }
    }
    /// `r`: the row; `k`: the vector within it.
    [[nodiscard]] HWY_INLINE V alongAt(std::size_t r, std::size_t k) const {
        return hn::Add(all(along + (row + static_cast<float>(r)) * alongY), alongColumns[k]);
    }
    [[nodiscard]] HWY_INLINE V acrossAt(std::size_t r, std::size_t k) const {
        return hn::Add(all(acrossAt(r)), acrossColumns[k]);
    }
    /// Of the whole row if the path is along it, else at the tile's middle column.
    [[nodiscard]] HWY_INLINE float acrossAt(std::size_t r) const {
        return across + (row + static_cast<float>(r)) * acrossY;
    }
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace proveout
HWY_AFTER_NAMESPACE();

#endif
