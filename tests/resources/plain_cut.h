// SPDX-License-Identifier: GPL-3.0-or-later
// A second, simple implementation for reading and cutting the samples: slow, point by point, and independent
// of the product.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/base/geometry.h"

namespace proveout::samples {

/// One motion block as a dense row of cutter tips.
struct PlainMove {
    int line = 0;
    bool rapid = false;
    std::vector<Vec3> tips; ///< at most 0.2 mm apart, both ends included
};

/// Reads G0 G1 G2 G3 in XY with I and J, absolute, mm. The first motion block must position all three axes.
[[nodiscard]] std::vector<PlainMove> readMoves(const std::string& program);

/// A block of stock with its top at Z0 and its lower-left corner at the origin, as heights at a spacing of 1
/// mm.
class PlainStock {
public:
    PlainStock(int width, int depth);

    /// Cuts with the tip of a ball of radius 5.5 at `tip`; returns the greatest depth removed.
    double cut(const Vec3& tip);
    [[nodiscard]] double height(int x, int y) const {
        return m_heights[static_cast<std::size_t>(y * m_columns + x)];
    }

private:
    int m_columns;
    int m_rows;
    std::vector<double> m_heights;
};

} // namespace proveout::samples
