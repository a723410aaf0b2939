// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/zmap/walled_map.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

namespace proveout {

namespace {

Vec2 gradient(const WalledRegion& region, const Vec2& at) {
    constexpr double kStep = 1e-6;
    const auto along = [&](const Vec2& way) {
        return (region.distance(at + way) - region.distance(at - way)) / (2 * kStep);
    };
    return glm::normalize(Vec2(along({kStep, 0}), along({0, kStep})));
}

double rectangle(const Vec2& at, const Vec2& half) {
    const Vec2 out = glm::abs(at) - half;
    return glm::length(glm::max(out, Vec2(0))) + std::min(std::max(out.x, out.y), 0.0);
}

Vec2 turned(const Vec2& at, double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return {std::cos(angle) * at.x + std::sin(angle) * at.y, std::cos(angle) * at.y - std::sin(angle) * at.x};
}

const Vec2 kMiddle(kWalledSize / 2 + 0.137, kWalledSize / 2 - 0.211);

} // namespace

std::vector<WalledRegion> walledRegions() {
    const auto circle = [](const Vec2& at) { return glm::length(at - kMiddle) - 10; };
    const auto slot = [](const Vec2& at) { return rectangle(turned(at - kMiddle, 17), {100, 4.3}); };
    const auto straight = [](const Vec2& at) { return rectangle(at - kMiddle, {8.4, 5.3}); };
    const auto aslant = [](const Vec2& at) { return rectangle(turned(at - kMiddle, 17), {8.4, 5.3}); };
    const auto diagonal = [](const Vec2& at) { return rectangle(turned(at - kMiddle, 45), {8.4, 5.3}); };
    const double circleArea = std::numbers::pi * 100;
    const double boxArea = 4 * 8.4 * 5.3;
    std::vector<WalledRegion> all;
    for (const bool pocket : {true, false}) {
        all.push_back({"circle", circle, circleArea, 6e-3, 0.7, pocket});
        all.push_back({"slot", slot, 0, 5e-3, 0, pocket});
        all.push_back({"rectangle", straight, boxArea, 5e-3, 0.1, pocket});
        all.push_back({"rectangle at 17 degrees", aslant, boxArea, 5e-3, 0.5, pocket});
        all.push_back({"rectangle at 45 degrees", diagonal, boxArea, 5e-3, 1.6, pocket});
    }
    return all;
}

WalledMap::WalledMap(const WalledRegion& region, double spacing, double stockHeight) : m_region(region) {
    const StockBox stock{{0, 0, 0}, kWalledSize, kWalledSize, stockHeight};
    m_grid = makeGrid(stock, spacing).value();
    ZMap zmap(stock, m_grid);
    for (std::size_t tile = 0; tile < zmap.tileCount(); ++tile) {
        Tile& heights = zmap.tileForWriting(tile);
        const IndexRect rect = zmap.tileRect(tile);
        for (int j = rect.j0; j < rect.j1; ++j)
            for (int i = rect.i0; i < rect.i1; ++i)
                heights.at(i - rect.i0, j - rect.j0) = isLow(place(i, j)) ? kWalledDepth : 0;
    }
    m_moment = zmap.snapshot();
    RimMap rims;
    for (std::size_t tile = 0; tile < zmap.tileCount(); ++tile)
        rims.push_back(rimsOf(tile));
    m_moment.setRims(std::move(rims));
    m_moment.setWalls(WallPoints(m_moment));
}

bool WalledMap::isLow(const Vec2& at) const {
    return (m_region.distance(at) < 0) == m_region.floorInside;
}

double WalledMap::fromOutline(const Vec3& vertex) const {
    return std::abs(m_region.distance(Vec2(vertex)));
}

bool WalledMap::isAtBorder(const Vec3& vertex) const {
    const Vec2 inside = glm::min(Vec2(vertex), Vec2(kWalledSize) - Vec2(vertex));
    return std::min(inside.x, inside.y) < 1.5 * m_grid.hx;
}

RimTilePtr WalledMap::rimsOf(std::size_t tile) const {
    RimTile rims;
    const IndexRect rect = m_moment.tileRect(tile);
    for (int j = rect.j0; j < rect.j1; ++j) {
        for (int i = rect.i0; i < rect.i1; ++i) {
            for (const bool alongY : {false, true})
                add(RimEdge{i - rect.i0, j - rect.j0, alongY}, i, j, rims);
        }
    }
    return rims.rims.empty() ? nullptr : std::make_shared<const RimTile>(std::move(rims));
}

void WalledMap::add(const RimEdge& edge, int i, int j, RimTile& rims) const {
    const int toI = i + (edge.alongY ? 0 : 1);
    const int toJ = j + (edge.alongY ? 1 : 0);
    if (toI >= m_grid.nx || toJ >= m_grid.ny || isLow(place(i, j)) == isLow(place(toI, toJ)))
        return;
    double from = 0;
    double to = 1;
    const auto at = [&](double way) { return glm::mix(place(i, j), place(toI, toJ), way); };
    for (int k = 0; k < 50; ++k) {
        const double middle = (from + to) / 2;
        (isLow(at(middle)) == isLow(at(0)) ? from : to) = middle;
    }
    const Vec2 normal = gradient(m_region, at(from)) * (m_region.floorInside ? 1.0 : -1.0);
    const auto wall = static_cast<std::uint16_t>(std::lround(from * 65535));
    rims.rims.push_back({edge.index(), wall, wall, RimSides::both, 0, kWalledDepth, inRimUnits(normal.x),
                         inRimUnits(normal.y)});
}

} // namespace proveout
