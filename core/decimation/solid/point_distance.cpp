// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/solid/point_distance.h"

namespace proveout {

double distanceToSegment(const Vec3& point, const Vec3& a, const Vec3& b) {
    const Vec3 way = b - a;
    const double length2 = glm::dot(way, way);
    const double t = length2 > 0 ? glm::clamp(glm::dot(point - a, way) / length2, 0.0, 1.0) : 0.0;
    return glm::length(point - (a + t * way));
}

double distanceToTriangle(const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 normal = glm::cross(b - a, c - a);
    const double size = glm::length(normal);
    const auto isInside = [&](const Vec3& from, const Vec3& to) {
        return glm::dot(glm::cross(to - from, point - from), normal) >= 0;
    };
    if (size > 0 && isInside(a, b) && isInside(b, c) && isInside(c, a))
        return glm::abs(glm::dot(point - a, normal)) / size;
    return glm::min(glm::min(distanceToSegment(point, a, b), distanceToSegment(point, b, c)),
                    distanceToSegment(point, c, a));
}

} // namespace proveout
