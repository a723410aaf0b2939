// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/part/nearest_on_facet.h"

namespace proveout {

namespace {

/// The nearest place of a side, which is from corner `k` to the next one.
NearestOnFacet nearestOnSide(const Vec3& point, const std::array<Vec3, 3>& corners, std::size_t k) {
    const std::size_t next = (k + 1) % 3;
    const Vec3 way = corners[next] - corners[k];
    const double along = glm::dot(point - corners[k], way);
    const double length2 = glm::dot(way, way);
    const auto feature = [](FacetFeature first, std::size_t index) {
        return static_cast<FacetFeature>(static_cast<std::size_t>(first) + index);
    };
    if (!(along > 0))
        return {corners[k], feature(FacetFeature::corner0, k)};
    if (!(along < length2))
        return {corners[next], feature(FacetFeature::corner0, next)};
    return {corners[k] + way * (along / length2), feature(FacetFeature::side0, k)};
}

} // namespace

NearestOnFacet nearestOnFacet(const Vec3& point, const std::array<Vec3, 3>& corners) {
    const Vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double size2 = glm::dot(normal, normal);
    bool isInside = size2 > 0;
    NearestOnFacet nearest{corners[0], FacetFeature::corner0};
    double least2 = -1;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& from = corners[k];
        const Vec3 way = corners[(k + 1) % 3] - from;
        if (size2 > 0 && glm::dot(glm::cross(way, point - from), normal) > 0)
            continue; // on the inner side of this one
        isInside = false;
        const NearestOnFacet onSide = nearestOnSide(point, corners, k);
        const Vec3 away = point - onSide.place;
        const double distance2 = glm::dot(away, away);
        if (least2 < 0 || distance2 < least2) {
            nearest = onSide;
            least2 = distance2;
        }
    }
    if (isInside)
        return {point - normal * (glm::dot(point - corners[0], normal) / size2), FacetFeature::inside};
    return nearest;
}

} // namespace proveout
