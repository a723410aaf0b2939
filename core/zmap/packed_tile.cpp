// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/zmap/packed_tile.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <stdexcept>
#include <type_traits>
#include <zstd.h>

namespace proveout {

namespace {

constexpr std::size_t kSize = Tile::kSize;
constexpr std::size_t kPoints = kSize * kSize;
constexpr std::size_t kWordBytes = sizeof(std::uint32_t);
constexpr int kLevel = 1;

/// The fields of a tile besides its heights.
struct Bounds {
    std::array<float, std::size_t{Tile::kBlocks} * Tile::kBlocks> blocks;
    float maximum;
    std::uint32_t loweredPoints;
};
static_assert(std::is_trivially_copyable_v<Bounds>);

using Words = std::array<std::uint32_t, kPoints>;
using Planes = std::array<std::uint8_t, kPoints * kWordBytes + sizeof(Bounds)>;

/// The difference of the differences of two neighbours in two rows. Integers wrap around, so that nothing is
/// lost, whatever the bits mean.
Words differences(const Tile& tile) {
    Words words;
    std::memcpy(words.data(), tile.heights.data(), sizeof words);
    for (std::size_t row = kSize; row-- > 1;) {
        for (std::size_t i = 0; i < kSize; ++i)
            words[row * kSize + i] -= words[(row - 1) * kSize + i];
    }
    for (std::size_t row = 0; row < kSize; ++row) {
        for (std::size_t i = kSize; i-- > 1;)
            words[row * kSize + i] -= words[row * kSize + i - 1];
    }
    return words;
}

void addUp(Words& words) {
    for (std::size_t row = 0; row < kSize; ++row) {
        for (std::size_t i = 1; i < kSize; ++i)
            words[row * kSize + i] += words[row * kSize + i - 1];
    }
    for (std::size_t row = 1; row < kSize; ++row) {
        for (std::size_t i = 0; i < kSize; ++i)
            words[row * kSize + i] += words[(row - 1) * kSize + i];
    }
}

/// Small numbers of either sign have zeros in the same bytes.
constexpr std::uint32_t folded(std::uint32_t word) {
    return (word << 1U) ^ (0U - (word >> 31U));
}
constexpr std::uint32_t unfolded(std::uint32_t word) {
    return (word >> 1U) ^ (0U - (word & 1U));
}

/// One per thread: it is larger than what it packs.
ZSTD_CCtx* packingContext() {
    struct Free {
        void operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
    };
    static thread_local const std::unique_ptr<ZSTD_CCtx, Free> context(ZSTD_createCCtx());
    if (!context)
        throw std::bad_alloc();
    return context.get();
}

} // namespace

std::vector<std::byte> packed(const Tile& tile) {
    const Words words = differences(tile);
    Planes planes;
    for (std::size_t point = 0; point < kPoints; ++point) {
        const std::uint32_t word = folded(words[point]);
        for (std::size_t byte = 0; byte < kWordBytes; ++byte)
            planes[byte * kPoints + point] = static_cast<std::uint8_t>(word >> (8 * byte));
    }
    const Bounds bounds{tile.blockMaxima, tile.maximum, tile.loweredPoints};
    std::memcpy(&planes[kPoints * kWordBytes], &bounds, sizeof bounds);
    std::array<std::byte, ZSTD_COMPRESSBOUND(sizeof(Planes))> space;
    const std::size_t size =
        ZSTD_compressCCtx(packingContext(), space.data(), space.size(), planes.data(), planes.size(), kLevel);
    if (ZSTD_isError(size) != 0)
        throw std::bad_alloc(); // the buffer is large enough for any result, so the only possible failure is
                                // a lack of memory
    return {space.begin(), space.begin() + static_cast<std::ptrdiff_t>(size)};
}

void unpack(std::span<const std::byte> bytes, Tile& tile) {
    Planes planes;
    const std::size_t size = ZSTD_decompress(planes.data(), planes.size(), bytes.data(), bytes.size());
    if (size != planes.size())
        throw std::runtime_error("a packed tile cannot be read");
    Words words;
    for (std::size_t point = 0; point < kPoints; ++point) {
        std::uint32_t word = 0;
        for (std::size_t byte = 0; byte < kWordBytes; ++byte)
            word |= std::uint32_t{planes[byte * kPoints + point]} << (8 * byte);
        words[point] = unfolded(word);
    }
    addUp(words);
    std::memcpy(tile.heights.data(), words.data(), sizeof words);
    Bounds bounds;
    std::memcpy(&bounds, &planes[kPoints * kWordBytes], sizeof bounds);
    tile.blockMaxima = bounds.blocks;
    tile.maximum = bounds.maximum;
    tile.loweredPoints = bounds.loweredPoints;
}

} // namespace proveout
