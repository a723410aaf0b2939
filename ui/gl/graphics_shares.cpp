// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/graphics_shares.h"

#include <algorithm>
#include <cstdint>

#include "ui/gl/coarse_points.h"
#include "ui/gl/height_pages.h"
#include "ui/gl/point_table.h"

namespace proveout {

namespace {

constexpr int kLargestPage = 256;
constexpr int kSmallestPage = 32;
/// With fewer slots, pages are made smaller: most of a large page would be beside the view.
constexpr std::size_t kFewSlots = 64;

/// Of the texture that names the layer of each page.
std::size_t layerBytes(const Grid& grid, int pagePoints) {
    const auto count = [&](int points) { return static_cast<std::size_t>(points / pagePoints + 1); };
    return sizeof(std::int16_t) * count(grid.nx) * count(grid.ny);
}

} // namespace

std::size_t GraphicsShares::mostWallBytes(const Grid& grid) {
    constexpr std::size_t kPerPoint = 72; // nine indices of four bytes, in slots of up to twice the size
    return kPerPoint * 2 * (static_cast<std::size_t>(grid.nx) + static_cast<std::size_t>(grid.ny));
}

std::size_t GraphicsShares::pageBytes() const {
    const auto side = static_cast<std::size_t>(pagePoints + 2 * HeightPages::kMargin);
    return sizeof(float) * side * side;
}

GraphicsShares GraphicsShares::of(const Grid& grid, std::size_t bytes, const TextureLimits& limits) {
    GraphicsShares shares;
    const CoarsePoints coarse =
        CoarsePoints::within(grid, std::min(bytes / 10 * 3, limits.bytes), limits.side);
    shares.coarseStep = coarse.step;
    shares.coarse = coarse.bytes();
    shares.lists = bytes / 5;
    const auto mostRows = static_cast<std::size_t>(limits.side); // of the texture with the table
    shares.vertices =
        std::min({bytes / 8, limits.bytes, mostRows * PointTable::kRow * sizeof(PointTable::Entry)});
    shares.walls = std::min(bytes / 8, mostWallBytes(grid));
    const std::size_t held = shares.coarse + shares.lists + shares.vertices + shares.walls;
    const auto setPage = [&](int points) {
        shares.pagePoints = points;
        const std::size_t used = held + layerBytes(grid, points);
        shares.pages = std::min(bytes > used ? bytes - used : 0, limits.bytes);
        shares.slotCount = shares.pages / shares.pageBytes();
    };
    const auto fits = [&](int points) { return points + 2 * HeightPages::kMargin <= limits.side; };
    int points = kLargestPage;
    for (setPage(points); (shares.slotCount < kFewSlots || !fits(points)) && points > kSmallestPage;)
        setPage(points /= 2);
    const auto layers = static_cast<std::size_t>(limits.layers);
    while (shares.slotCount > layers && fits(2 * points))
        setPage(points *= 2);
    shares.slotCount = std::min(shares.slotCount, layers);
    return shares;
}

} // namespace proveout
