// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/geometry/transformation.h"

#include <cmath>
#include <numbers>

namespace proveout {

namespace {

bool has(std::uint8_t axes, int axis) {
    return (axes >> static_cast<unsigned>(axis) & 1U) != 0;
}

Vec3 turnedAbout(Vec3 point, const Vec3& centre, Plane plane, double degrees) {
    const PlaneAxes axis = axes(plane);
    const double angle = degrees * std::numbers::pi / 180;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const double u = point[axis.first] - centre[axis.first];
    const double v = point[axis.second] - centre[axis.second];
    point[axis.first] = centre[axis.first] + u * c - v * s;
    point[axis.second] = centre[axis.second] + u * s + v * c;
    return point;
}

} // namespace

std::uint8_t Transformation::mixedAxes() const {
    if (!turned || degrees == 0)
        return 0;
    const PlaneAxes axis = axes(plane);
    return static_cast<std::uint8_t>(1U << static_cast<unsigned>(axis.first) |
                                     1U << static_cast<unsigned>(axis.second));
}

std::uint8_t Transformation::unplacedAxes() const {
    const std::uint8_t mixed = mixedAxes();
    const auto bits = static_cast<std::uint8_t>((scaled ? scaleUnknown : 0U) | (turnUnknown & mixed));
    return (bits & mixed) != 0 ? static_cast<std::uint8_t>(bits | mixed) : bits;
}

Vec3 Transformation::mirror(const Vec3& point) const {
    Vec3 result = point;
    for (int axis = 0; axis < 3; ++axis) {
        if (has(mirrored, axis))
            result[axis] = 2 * mirrorAt[axis] - point[axis];
    }
    return result;
}

Vec3 Transformation::stretch(const Vec3& point) const {
    const Vec3 image = mirror(point);
    return scaled ? scaleAt + (image - scaleAt) * factors : image;
}

Vec3 Transformation::apply(const Vec3& point) const {
    const Vec3 image = stretch(point);
    return turned ? turnedAbout(image, turnAt, plane, degrees) : image;
}

Vec3 Transformation::unturn(const Vec3& point) const {
    return turned ? turnedAbout(point, turnAt, plane, -degrees) : point;
}

Vec3 Transformation::undo(const Vec3& point) const {
    const Vec3 image = unturn(point);
    return mirror(scaled ? scaleAt + (image - scaleAt) / factors : image);
}

bool Transformation::flips(Plane arcs) const {
    const PlaneAxes axis = axes(arcs);
    const bool first = has(mirrored, axis.first) != (scaled && factors[axis.first] < 0);
    const bool second = has(mirrored, axis.second) != (scaled && factors[axis.second] < 0);
    return first != second;
}

bool Transformation::keepsCircles(Plane arcs) const {
    const PlaneAxes axis = axes(arcs);
    return !scaled || std::abs(factors[axis.first]) == std::abs(factors[axis.second]);
}

bool Transformation::keepsPlane(Plane arcs) const {
    return mixedAxes() == 0 || arcs == plane;
}

} // namespace proveout
