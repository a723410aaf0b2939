// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <memory>

#include "core/cutting/kernels/tile_pass.h"

namespace proveout {

/// How far ahead of a point a cutter is when it is lowest over that point depends, along one path, only on
/// the point's distance from the path; finding it is most of the work on a point. For a motion over many
/// points it is solved once, at some distances, and approximated in bands of that one variable by
/// polynomials.
struct LeadBands {
    static constexpr std::size_t kMost = 64;
    static constexpr std::size_t kDegree = 5;

    /// A polynomial of (variable - middle) · perHalf, which ranges from -1 to 1; coefficients from the
    /// constant on.
    struct Band {
        float begin; ///< of the variable; the band ends where the next one begins
        float middle;
        float perHalf;
        std::array<float, kDegree + 1> coefficients;
    };

    /// Straight paths: the square of the distance ahead, as a function of the square of the distance beside
    /// the path. Round ones: the square of the chord, on a circle of radius 1, as a function of the distance
    /// outside the path's circle; below cones, divided by the square of that distance.
    std::array<Band, kMost> bands;
    std::size_t count = 0;
    /// Round paths: the cutter may also be lowest over a point where the point is on its rim.
    bool rim = false;
};

/// The bands of a pass that is not level, valid over any tile, including its rim. Wherever heights by the
/// polynomials were checked, they are within 3e-5 mm of those without. Null if that needs too many bands, if
/// there is more than one lowest place, and for passes whose closed form costs less.
[[nodiscard]] std::shared_ptr<const LeadBands> leadBands(const TilePass& pass);

} // namespace proveout
