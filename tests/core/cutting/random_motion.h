// SPDX-License-Identifier: GPL-3.0-or-later
// Random cutters and motions for a small stock.
#pragma once

#include <iosfwd>
#include <random>
#include <span>
#include <string>

#include "core/cutter/cutter.h"
#include "core/nc/program/motion.h"
#include "core/zmap/stock.h"

namespace proveout {

using Random = std::mt19937;

[[nodiscard]] double uniform(Random& random, double lo, double hi);

[[nodiscard]] Cutter cutterOf(const std::string& spec);
/// A random cutter of the shape with this key, mostly 2 to 12 mm wide.
[[nodiscard]] Cutter randomCutter(Random& random, const std::string& shape);

[[nodiscard]] Motion straightMotion(const Vec3& start, const Vec3& end);
/// `angle` and `radius` are those of the start in the plane; the end follows from the sweep.
[[nodiscard]] Motion arcMotion(Plane plane, const Vec3& centre, double radius, double angle, double sweep,
                               double climb, double endRadius);

enum class StraightKind { level, sloped, steep, plunge, still };
[[nodiscard]] Motion randomStraight(Random& random, const StockBox& stock, StraightKind kind);

enum class ArcKind { level, helix, spiral, turns };
[[nodiscard]] Motion randomArc(Random& random, const StockBox& stock, Plane plane, ArcKind kind);

/// One row per kind of motion.
struct MotionRow {
    const char* name;
    Motion (*make)(Random& random, const StockBox& stock);
    int samples; ///< of the path, enough for the oracle to 1e-3 mm
};
[[nodiscard]] std::span<const MotionRow> motionRows();
void PrintTo(const MotionRow& row, std::ostream* out);

/// The text that is printed when a random case fails.
[[nodiscard]] std::string reported(const Cutter& cutter, const Motion& motion);

/// The largest difference of `cut` from the oracle over every `stride`-th row and column of a fresh map,
/// without points on the rim.
[[nodiscard]] double largestError(const Cutter& cutter, const Motion& motion, const StockBox& stock,
                                  double spacing, int samples, int stride = 1);
/// The same over the given number of random points near the path.
[[nodiscard]] double largestErrorNear(Random& random, const Cutter& cutter, const Motion& motion,
                                      const StockBox& stock, double spacing, int samples, int points);

} // namespace proveout
