// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to this room.
#pragma once

#include <array>
#include <optional>

namespace proveout {

/// A place of the surface below a wall.
struct FootSample {
    double distance; ///< from the wall, mm
    double height;   ///< relative to the top of the stock, mm
};

/// The surface below a wall that is not level: what the corner of a cutter leaves. It is a conic whose axis
/// is along the wall, as are the circles of bull-nose and ball cutters, the ellipses in which a grid line
/// cuts them, and the straight lines of tapered cutters. Past its lowest place it is level.
struct RoundFoot {
    double bottom = 0; ///< of the wall, where the foot begins
    double linear = 0; ///< the square of how far it falls: this times the distance …
    double square = 0; ///< … and this times its square; both 0: it is level

    /// Of what a grid line crosses. `atWall`: a little beyond the wall, which is between `highest` and that
    /// height; `first` and `second`: the next two points of the grid. Nothing if it does not fall.
    [[nodiscard]] static std::optional<RoundFoot> through(const FootSample& atWall, double highest,
                                                          const FootSample& first, const FootSample& second);

    /// The same from its `bottom` and two more places.
    [[nodiscard]] static std::optional<RoundFoot> through(const FootSample& first, const FootSample& second,
                                                          double bottom);
    [[nodiscard]] bool isLevel() const { return linear == 0 && square == 0; }
    /// How far below `bottom` it is.
    [[nodiscard]] double fall(double distance) const;
    [[nodiscard]] double slopeAt(double distance) const;
    /// The mean of fall() over a triangle whose corners are at these distances.
    [[nodiscard]] double meanFall(std::array<double, 3> distances) const;
    /// How much lower a strip from the wall to `distance` has to begin than otherwise if it is to have the
    /// volume, too, that is between the foot beyond it and straight lines from one step to the next.
    [[nodiscard]] double sagBeyond(double distance, double step) const;
    /// The same foot by distances that are `factor` times as large.
    [[nodiscard]] RoundFoot scaled(double factor) const {
        return {bottom, linear / factor, square / (factor * factor)};
    }
};

[[nodiscard]] inline RoundFoot between(const RoundFoot& a, const RoundFoot& b) {
    return {(a.bottom + b.bottom) / 2, (a.linear + b.linear) / 2, (a.square + b.square) / 2};
}

} // namespace proveout
