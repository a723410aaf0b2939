// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/decimation/solid/solid.h"

namespace proveout::test {

/// The distances of points from those triangles of a mesh that face upwards, computed with CGAL only.
struct PointDistances {
    double vertical = 0; ///< along Z, by rays against an AABB tree; infinity if there is no triangle at a
                         ///< point
    double nearest = 0;  ///< to the nearest point of any triangle
};
[[nodiscard]] PointDistances distancesToTop(const std::vector<Vec3>& points, const TriangleMesh& solid);

/// The largest distance of the points from the nearest point of a mesh, by CGAL's AABB tree; infinity if CGAL
/// does not accept the triangles as a mesh.
[[nodiscard]] double farthestFrom(const TriangleMesh& mesh, const std::vector<Vec3>& points);

struct SidedDistance {
    double distance; ///< from the nearest place of the mesh
    bool isInside;
};
/// Of points from a closed mesh, by CGAL's AABB tree and the parity of its rays.
[[nodiscard]] std::vector<SidedDistance> sidedDistances(const std::vector<Vec3>& points,
                                                        const TriangleMesh& mesh);

/// The two-sided Hausdorff distance of two meshes, at most `bound` above the true value.
[[nodiscard]] double symmetricHausdorff(const TriangleMesh& a, const TriangleMesh& b, double bound);

/// Whether that distance is larger than `distance`, determined by CGAL within `error`; faster than computing
/// the distance.
[[nodiscard]] bool isHausdorffLarger(const TriangleMesh& a, const TriangleMesh& b, double distance,
                                     double error);

} // namespace proveout::test
