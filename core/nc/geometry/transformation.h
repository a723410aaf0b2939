// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/base/geometry.h"
#include "core/nc/program/motion.h"

namespace proveout {

/// Mirror image, scaling and rotation of program coordinates, in the order in which the control applies them.
/// The centre of each is in the coordinates that result from those before it. Lengths in mm. A value. Source:
/// FANUC's operator's manuals, programmable mirror image.
struct Transformation {
    std::uint8_t mirrored = 0; ///< AxisBits, G51.1
    bool scaled = false;       ///< G51
    bool turned = false;       ///< G68
    Plane plane = Plane::xy;   ///< of the rotation
    Vec3 mirrorAt{0};
    Vec3 factors{1}; ///< never 0
    Vec3 scaleAt{0};
    Vec3 turnAt{0};
    double degrees = 0; ///< right-handed about the normal of the plane
    /// AxisBits of centres that should have been at the position of the tool, which was unknown.
    std::uint8_t scaleUnknown = 0;
    std::uint8_t turnUnknown = 0;

    [[nodiscard]] bool any() const { return mirrored != 0 || scaled || turned; }
    /// Axes whose position depends on more than their own words.
    [[nodiscard]] std::uint8_t mixedAxes() const;
    /// Axes whose position depends on an unknown centre.
    [[nodiscard]] std::uint8_t unplacedAxes() const;

    [[nodiscard]] Vec3 apply(const Vec3& point) const;
    [[nodiscard]] Vec3 undo(const Vec3& point) const;
    /// Mirror image alone, and combined with scaling; axis by axis.
    [[nodiscard]] Vec3 mirror(const Vec3& point) const;
    [[nodiscard]] Vec3 stretch(const Vec3& point) const;
    /// Converts the result of `apply` back to that of `stretch`.
    [[nodiscard]] Vec3 unturn(const Vec3& point) const;

    /// Whether an arc in `arcs` reverses its direction.
    [[nodiscard]] bool flips(Plane arcs) const;
    /// Whether an arc in `arcs` stays a circle.
    [[nodiscard]] bool keepsCircles(Plane arcs) const;
    /// Whether an arc in `arcs` stays in the same plane of the machine.
    [[nodiscard]] bool keepsPlane(Plane arcs) const;

    bool operator==(const Transformation&) const = default;
};

} // namespace proveout
