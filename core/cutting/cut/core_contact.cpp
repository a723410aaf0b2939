// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/cut/core_contact.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace proveout {

namespace {

constexpr double kStraight = 0.01; ///< mm in X and Y, as the end of a rotated motion is rounded

float heightAt(const ZMap& map, int i, int j) {
    constexpr int kSize = Tile::kSize;
    const auto tile = static_cast<std::size_t>(j / kSize * map.tilesX() + i / kSize);
    return map.tile(tile).at(i % kSize, j % kSize);
}

/// The grid points from `lo` to `hi` along one axis: the first, and the one after the last.
struct Points {
    int first;
    int last;

    Points(double lo, double hi, double origin, double spacing, int count)
        : first(static_cast<int>(std::clamp(std::ceil((lo - origin) / spacing), 0.0, double(count)))),
          last(static_cast<int>(std::clamp(std::floor((hi - origin) / spacing) + 1, 0.0, double(count)))) {}
};

} // namespace

bool plungesWithCore(const Cutter& cutter, const Motion& motion) {
    return !cutter.data().centreCutting && motion.kind == MotionKind::feed && motion.known() &&
           motion.end.z < motion.start.z &&
           std::hypot(motion.end.x - motion.start.x, motion.end.y - motion.start.y) <= kStraight;
}

PartContact coreContact(const ZMap& before, const Cutter& cutter, const Motion& motion) {
    PartContact contact;
    const Grid& grid = before.grid();
    const double radius = kCoreWidth * cutter.radius();
    const Vec3& tip = motion.end;
    const Points columns(tip.x - radius, tip.x + radius, grid.x(0), grid.hx, grid.nx);
    const Points rows(tip.y - radius, tip.y + radius, grid.y(0), grid.hy, grid.ny);
    for (int j = rows.first; j < rows.last; ++j)
        for (int i = columns.first; i < columns.last; ++i) {
            const double r = std::hypot(grid.x(i) - tip.x, grid.y(j) - tip.y);
            const float height = heightAt(before, i, j);
            if (r > radius || height <= before.floor())
                continue;
            const double bottom = std::max(tip.z + cutter.height(r), before.stock().floorZ());
            const double depth = before.stock().topZ() + static_cast<double>(height) - bottom;
            if (depth > contact.depth)
                contact = {depth, Vec3(grid.x(i), grid.y(j), bottom)};
        }
    return contact.depth > 2 * kCoreHollow * cutter.radius() ? contact : PartContact();
}

} // namespace proveout
