// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/cut/stock_crossing.h"

#include <algorithm>
#include <cmath>

namespace proveout {

namespace {

/// Half the distance between the lines whose crossings give a wall's direction, mm.
constexpr double kAside = 1e-3;

/// The stock along a line that is `aside` to the left of another.
class StockAlong {
public:
    StockAlong(const StockTop& stock, const EdgeLine& line, double aside)
        : m_stock(stock), m_line(line), m_aside(line.unseen({0, aside})) {}

    [[nodiscard]] bool below(double place) const {
        return m_stock.height(m_line.at(place) + m_aside) < m_line.heightAt(place);
    }

    /// Where it falls below the line's height between two places; the nearer one if it is above, or below, at
    /// both.
    [[nodiscard]] double fallBetween(double lo, double hi) const {
        if (below(lo))
            return lo;
        if (!below(hi))
            return hi;
        for (int halving = 0; halving < 60 && hi - lo > 1e-10; ++halving) {
            const double middle = (lo + hi) / 2;
            (below(middle) ? hi : lo) = middle;
        }
        return lo;
    }

private:
    const StockTop& m_stock;
    const EdgeLine& m_line;
    Vec2 m_aside;
};

Vec2 outwardsAt(const StockTop& stock, const EdgeLine& line, double place) {
    constexpr double kAround = 200 * kAside;
    const auto fallAside = [&](double aside) {
        return StockAlong(stock, line, aside).fallBetween(place - kAround, place + kAround) - place;
    };
    const Vec2 wall(fallAside(kAside) - fallAside(-kAside), 2 * kAside);
    // The high side is towards the line's start.
    return line.unseen(Vec2(-wall.y, wall.x) / glm::length(wall));
}

} // namespace

EdgeCrossing crossingWithStock(const StockTop& stock, const EdgeLine& line) {
    constexpr int kSamples = 8;
    const StockAlong along(stock, line, 0);
    for (int k = 1; k <= kSamples; ++k) {
        const double place = line.length * k / kSamples;
        if (!along.below(place))
            continue;
        const double first = along.fallBetween(line.length * (k - 1) / kSamples, place);
        return {first, outwardsAt(stock, line, first)};
    }
    return {};
}

} // namespace proveout
