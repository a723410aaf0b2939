// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "core/base/geometry.h"

namespace proveout::samples {

/// Height of a design surface over (x, y), mm.
using Surface = std::function<double(double x, double y)>;

/// Heights on a square lattice, row by row; mm. Value type.
struct HeightMap {
    double x0 = 0;
    double y0 = 0;
    double step = 1;
    int nx = 0;
    int ny = 0;
    std::vector<double> z;

    [[nodiscard]] double x(int i) const { return x0 + step * i; }
    [[nodiscard]] double y(int j) const { return y0 + step * j; }
    [[nodiscard]] double at(int i, int j) const {
        return z[static_cast<std::size_t>(j) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(i)];
    }
    [[nodiscard]] int columnAt(double px) const; ///< of the nearest lattice point
    [[nodiscard]] int rowAt(double py) const;
};

/// Samples `surface` over [lo, hi]. Heights are rounded to a nanometre, so that everything computed from
/// them is the same whatever the last bit of the C library's functions is.
[[nodiscard]] HeightMap sample(const Surface& surface, const Vec2& lo, const Vec2& hi, double step);

/// The drop-cutter surface of a ball: at each lattice point the least height of its tip at which it touches
/// no lattice point of `surface`, max over the disc of z - h(r). Same lattice; points beyond the map count
/// as absent.
[[nodiscard]] HeightMap dropBall(const HeightMap& surface, double radius);

} // namespace proveout::samples
