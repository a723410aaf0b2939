// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "core/part/design_part.h"
#include "core/zmap/stock.h"

namespace proveout {

/// How high a part is over each point of a grid: what three axes can reach of it there. Immutable; any
/// thread.
class PartTop {
public:
    static constexpr float kNone = -std::numeric_limits<float>::infinity(); ///< the part is not there

    PartTop() = default;
    /// In parallel; a point exactly over the outline of a facet is over it.
    PartTop(const DesignPart& part, const StockBox& stock, const Grid& grid);

    /// Relative to the top of the stock, as the heights of a z-map.
    [[nodiscard]] float at(int i, int j) const {
        return m_heights[static_cast<std::size_t>(j) * static_cast<std::size_t>(m_nx) +
                         static_cast<std::size_t>(i)];
    }

private:
    void add(const DesignPart& part, std::size_t facet, const Grid& grid, double zero, int firstRow,
             int lastRow);

    int m_nx = 0;
    std::vector<float> m_heights;
};

} // namespace proveout
