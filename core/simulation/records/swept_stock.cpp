// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/records/swept_stock.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "core/base/parallel.h"
#include "core/simulation/records/reached_place.h"
#include "core/simulation/run/block_cutter.h"

namespace proveout {

namespace {

constexpr std::size_t kMotionsOfLook = 4096;

std::size_t motionsBefore(const Frame& moment) {
    return moment.block == 0 ? 0 : moment.program->blockMotions(moment.block - 1).last;
}

} // namespace

SweptStock::SweptStock(const Frame& moment, const WorkContext& context)
    : m_moment(moment), m_tools(*moment.program, *moment.setup),
      m_index(moment.zmap.stock(), moment.zmap.grid()) {
    const StockShape& shape = moment.setup->shape;
    if (shape.kind != StockKind::box)
        m_uncut = topOf(moment.zmap.stock(), shape, moment.zmap.grid());
    const std::size_t motions = motionsBefore(moment);
    for (std::size_t first = 0; first < motions && !context.stopped(); first += kMotionsOfLook)
        eachCutterMotion(*moment.program, {first, std::min(first + kMotionsOfLook, motions)}, *moment.setup,
                         m_tools, [&](const CutterMotion& motion) { m_index.append(motion); });
}

bool SweptStock::isUncut(const Vec3& place) const {
    const StockBox& stock = m_moment.zmap.stock();
    const double height = m_uncut == nullptr ? 0 : m_uncut->height(Vec2(place));
    return place.z <= stock.topZ() + height && place.z >= stock.floorZ() - kOnSurface;
}

std::vector<bool> SweptStock::isMaterial(std::span<const Vec3> places, const WorkContext& context) const {
    const Grid& grid = m_moment.zmap.grid();
    const auto tileOf = [&](const Vec3& place) -> std::optional<std::size_t> {
        const double i = std::floor((place.x - grid.x0) / grid.hx);
        const double j = std::floor((place.y - grid.y0) / grid.hy);
        if (!(i >= 0 && j >= 0 && i <= grid.nx - 1 && j <= grid.ny - 1))
            return std::nullopt;
        return static_cast<std::size_t>((static_cast<int>(j) / Tile::kSize) * m_moment.zmap.tilesX() +
                                        static_cast<int>(i) / Tile::kSize);
    };
    std::vector<std::vector<std::uint32_t>> ofTiles(m_moment.zmap.tileCount());
    std::vector<std::uint8_t> isMaterial(places.size(), 0);
    for (std::size_t k = 0; k < places.size(); ++k)
        if (const auto tile = tileOf(places[k]); tile && isUncut(places[k])) {
            ofTiles[*tile].push_back(static_cast<std::uint32_t>(k));
            isMaterial[k] = 1;
        }
    const std::size_t motions = m_index.motionCount();
    inParallel(ofTiles.size(), [&](std::size_t tile) {
        std::vector<std::uint32_t>& left = ofTiles[tile];
        if (left.empty())
            return;
        for (const Program::MotionRange& range : m_index.over(tile, motions))
            for (std::size_t first = range.first; first < range.last && !left.empty() && !context.stopped();
                 first += kMotionsOfLook)
                eachCutterMotion(*m_moment.program, {first, std::min(first + kMotionsOfLook, range.last)},
                                 *m_moment.setup, m_tools, [&](const CutterMotion& motion) {
                                     std::erase_if(left, [&](std::uint32_t k) {
                                         const bool isReached = reaches(motion, places[k]);
                                         isMaterial[k] = isReached ? 0 : isMaterial[k];
                                         return isReached;
                                     });
                                 });
    });
    return {isMaterial.begin(), isMaterial.end()};
}

} // namespace proveout
