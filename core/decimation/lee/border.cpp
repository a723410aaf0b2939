// SPDX-License-Identifier: GPL-3.0-or-later
// Borders are simplified before regions, each by its own samples, by the same rules as regions: a vertex is
// removed if its distance to the line through its neighbours plus its accumulated error is within the
// allowance.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/decimation/lattice/lattice_scan.h"
#include "core/decimation/lee/vertex_error.h"
#include "core/decimation/regions/random_order.h"
#include "core/decimation/regions/region_decimator.h"

namespace proveout {

namespace {

class BorderPolyline {
public:
    BorderPolyline(std::span<const float> heights, double step)
        : m_heights(heights), m_step(step), m_before(heights.size()), m_after(heights.size()),
          m_error(heights.size(), 0.0) {
        for (std::size_t k = 0; k < heights.size(); ++k) {
            m_before[k] = k - 1;
            m_after[k] = k + 1;
        }
    }

    void tryRemove(std::size_t k, const DecimationParameters& parameters, double limit) {
        const std::size_t a = m_before[k];
        const std::size_t b = m_after[k];
        const double total = lineDistance(fromVertex(k, a), fromVertex(k, b)) + m_error[k];
        if (total > parameters.allowance || (parameters.certify && !chordWithin(a, b, limit)))
            return;
        // Collapses along the shorter edge, as in a region; the resulting line is the same either way, only
        // the error moves to a different vertex.
        const bool intoB = glm::length(fromVertex(k, b)) < glm::length(fromVertex(k, a));
        m_error[intoB ? b : a] += total;
        m_after[a] = b;
        m_before[b] = a;
    }

    [[nodiscard]] BorderLine kept() const {
        BorderLine line;
        for (std::size_t k = 0; k < m_heights.size(); k = m_after[k])
            line.kept.push_back(static_cast<std::uint32_t>(k));
        return line;
    }

private:
    [[nodiscard]] Vec2 fromVertex(std::size_t k, std::size_t other) const {
        return {m_step * (static_cast<double>(other) - static_cast<double>(k)),
                double{m_heights[other]} - double{m_heights[k]}};
    }

    [[nodiscard]] bool chordWithin(std::size_t a, std::size_t b, double limit) const {
        const double length = static_cast<double>(b - a);
        for (std::size_t k = a + 1; k < b; ++k) {
            const double z = (static_cast<double>(b - k) * double{m_heights[a]} +
                              static_cast<double>(k - a) * double{m_heights[b]}) /
                             length;
            if (std::abs(double{m_heights[k]} - z) > limit)
                return false;
        }
        return true;
    }

    std::span<const float> m_heights;
    double m_step;
    std::vector<std::size_t> m_before;
    std::vector<std::size_t> m_after;
    std::vector<double> m_error;
};

} // namespace

BorderLine simplifyBorder(std::span<const float> heights, double step, std::uint64_t seed,
                          const DecimationParameters& parameters) {
    BorderPolyline polyline(heights, step);
    // The middle of two cells is next to both corners; see snapToKept().
    const bool simplifies = parameters.allowance > 0 && heights.size() > 3;
    if (!simplifies)
        return polyline.kept();
    std::vector<std::uint32_t> order(heights.size() - 2);
    std::iota(order.begin(), order.end(), 1U);
    arrange(order, parameters.order, seed);
    const double limit = parameters.allowance - roundingGuard(heights);
    for (const std::uint32_t k : order)
        polyline.tryRemove(k, parameters, limit);
    return polyline.kept();
}

} // namespace proveout
