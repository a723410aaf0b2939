// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/decimation/solid/solid.h"

namespace proveout::test {

/// How far points lie from the triangles of a mesh that face upwards, found by CGAL alone.
struct PointDistances {
    double vertical = 0; ///< along Z, by rays against an AABB tree; infinity where a point has no triangle
    double nearest = 0;  ///< to the nearest point of any triangle
};
[[nodiscard]] PointDistances distancesToTop(const std::vector<Vec3>& points, const TriangleMesh& solid);

/// How far the farthest of the points lies from the nearest point of a mesh, by CGAL's AABB tree; infinity
/// where CGAL finds the triangles to be no mesh.
[[nodiscard]] double farthestFrom(const TriangleMesh& mesh, const std::vector<Vec3>& points);

/// The two-sided Hausdorff distance of two meshes, within `bound` above the true one.
[[nodiscard]] double symmetricHausdorff(const TriangleMesh& a, const TriangleMesh& b, double bound);

/// Whether that distance is larger than `distance`, which CGAL tells within `error`; sooner than the
/// distance.
[[nodiscard]] bool isHausdorffLarger(const TriangleMesh& a, const TriangleMesh& b, double distance,
                                     double error);

} // namespace proveout::test
