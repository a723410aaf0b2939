// SPDX-License-Identifier: GPL-3.0-or-later
// Z-maps with steep walls, anywhere, and the distance of a file from them.
#pragma once

#include <cstdint>
#include <functional>

#include "core/decimation/solid/solid.h"
#include "core/zmap/zmap.h"

namespace proveout::test {

/// A z-map of a stock 25 mm high with its upper corner at min X and min Y at `corner`.
ZMapSnapshot mapAt(const Vec3& corner, double width, double depth, double spacing,
                   const std::function<double(int i, int j)>& height);

/// A wave on a stock whose upper corner at min X and min Y is at X = `far`; its slope is 1.2 × `height`,
/// steep.
ZMapSnapshot waveAt(double far, double height = 9);

/// A wavy floor with round pockets; their walls are vertical, one cell wide.
ZMapSnapshot pocketsAt(const Vec3& corner, double spacing, std::uint32_t seed);

/// The largest vertical distance between the triangles of a file that face upwards and the full mesh of a
/// map: at the grid points, and at points within the triangles. In long double, without any code of
/// core/decimation. Points on the outline are measured at the nearest point of the rounded one.
double distanceFrom(const ZMapSnapshot& zmap, const TriangleMesh& file);

} // namespace proveout::test
