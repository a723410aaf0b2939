// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/rows/arc_row.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>

#include "core/cutting/rows/circle_row.h"
#include "core/cutting/rows/helix_row.h"
#include "core/cutting/rows/straight_row.h"

namespace proveout {

namespace {

std::uint64_t bitsOf(const Columns& columns) {
    const std::uint64_t upToEnd =
        columns.end >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << columns.end) - 1;
    return upToEnd & ~((std::uint64_t{1} << columns.begin) - 1);
}

/// Calls `work` with each run of set bits.
template<class Work>
void forEachRun(std::uint64_t bits, Work&& work) {
    while (bits != 0) {
        const int begin = std::countr_zero(bits);
        const int length = std::countr_one(bits >> begin);
        work(Columns{begin, begin + length});
        bits &= ~bitsOf({begin, begin + length});
    }
}

void searchPoints(const ConvexProfile& profile, const ArcPath& path, const ArcPart& part,
                  const RowPoints& row, std::uint64_t points, float* out) {
    for (; points != 0; points &= points - 1) {
        const int k = std::countr_zero(points);
        const Vec2 point(row.x + row.step * k, row.y);
        const double known = out[k];
        out[k] = std::min(out[k], static_cast<float>(arcPartEnvelope(profile, path, part, point, known)));
    }
}

/// A part of the path and the points of a row that it may touch.
struct Touch {
    const ArcPart* part;
    std::uint64_t points;
};

std::vector<Touch> touchesOf(const std::vector<ArcPart>& parts, double reach, const RowPoints& row) {
    std::vector<Touch> touches;
    for (const ArcPart& part : parts) {
        if (row.y < part.lo.y - reach || row.y > part.hi.y + reach)
            continue;
        const Columns columns = columnsUnder(rowSpan(part.chord, reach + part.bulge, row.y), row);
        if (!columns.empty())
            touches.push_back({&part, bitsOf(columns)});
    }
    return touches;
}

/// The points that may be lowered. A part deviates from its chord by no more than its bulge, so the chord's
/// own envelope, with the profile wider and the path lower by that, is nowhere above. A point is skipped for
/// all parts or for none: the result of a search may depend, within its accuracy, on earlier results.
std::uint64_t worthwhile(const ConvexProfile& profile, const std::vector<Touch>& touches,
                         const RowPoints& row, const float* heights) {
    std::array<float, 64> below;
    below.fill(std::numeric_limits<float>::infinity());
    for (const Touch& touch : touches) {
        StraightPath lower = touch.part->chord;
        lower.z -= touch.part->bulge;
        const ConvexProfile wider = profile.dilated(touch.part->bulge);
        forEachRun(touch.points,
                   [&](const Columns& run) { straightRow(wider, lower, row, run, below.data()); });
    }
    std::uint64_t points = 0;
    // The bound and the heights are rounded to float, so nearly equal values are not surely above.
    constexpr float kRounding = 1e-4F;
    for (int k = 0; k < row.count; ++k)
        points |= std::uint64_t{below[static_cast<std::size_t>(k)] < heights[k] + kRounding} << k;
    return points;
}

} // namespace

Columns arcRow(const ConvexProfile& profile, const ArcPath& path, const std::vector<ArcPart>& parts,
               double reach, const RowPoints& row, const float* heights, float* out) {
    const std::vector<Touch> touches = touchesOf(parts, reach, row);
    if (touches.empty())
        return {};
    std::uint64_t asked = 0;
    if (path.levelCircle()) {
        for (const Touch& touch : touches)
            asked |= touch.points;
        forEachRun(asked, [&](const Columns& run) { circleRow(profile, path, row, run, out); });
        return {std::countr_zero(asked), 64 - std::countl_zero(asked)};
    }
    const bool aboutZ = path.normal == 2 && profile.side != ConvexProfile::Side::line;
    const std::uint64_t open = worthwhile(profile, touches, row, heights);
    for (const Touch& touch : touches) {
        std::uint64_t points = touch.points & open;
        if (points == 0)
            continue;
        asked |= points;
        if (aboutZ) {
            const Columns columns{std::countr_zero(points), 64 - std::countl_zero(points)};
            points &= helixRow(profile, path, *touch.part, row, columns, out);
        }
        searchPoints(profile, path, *touch.part, row, points, out);
    }
    return asked == 0 ? Columns{} : Columns{std::countr_zero(asked), 64 - std::countl_zero(asked)};
}

} // namespace proveout
