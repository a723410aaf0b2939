// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <memory>

#include "core/cutting/kernels/tile_pass.h"

namespace proveout {

/// How far ahead of a point a cutter stands when it is lowest over it depends, along one path, on where the
/// point lies beside it and on nothing else; and finding it is most of the work on a point. For a motion over
/// many points it is found once, in some places, and told in bands of that one variable by polynomials.
struct LeadBands {
    static constexpr std::size_t kMost = 64;
    static constexpr std::size_t kDegree = 5;

    /// A polynomial of (variable - middle) · perHalf, which goes from -1 to 1; from the constant on.
    struct Band {
        float begin; ///< of the variable; it ends where the next one begins
        float middle;
        float perHalf;
        std::array<float, kDegree + 1> coefficients;
    };

    /// Straight paths: the square of the distance ahead, by the square of that beside the path. Round ones:
    /// the square of the chord, on a circle of radius 1, by how far outside the path's circle; below cones
    /// over the square of that.
    std::array<Band, kMost> bands;
    std::size_t count = 0;
    /// Round paths: the cutter may also be lowest over a point where that is on its rim.
    bool rim = false;
};

/// Of a pass that is not level, as it is over any tile, with its rim; wherever heights by the polynomials
/// were tried they are within 3e-5 mm of those without. None where that takes too many bands, where there is
/// more than one such place, and for passes whose closed form costs less.
[[nodiscard]] std::shared_ptr<const LeadBands> leadBands(const TilePass& pass);

} // namespace proveout
