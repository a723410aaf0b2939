// SPDX-License-Identifier: GPL-3.0-or-later
// The z-map points that a triangle covers, and the height of the triangle at them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>

namespace proveout {

/// A corner of a triangle: a point of the region (column, row; whole numbers) and its height, mm.
struct LatticeCorner {
    double i;
    double j;
    double z;
};

/// The points (first … last, row), and the heights of the triangle there: z, z + slope, …
struct LatticeRun {
    int row;
    int first;
    int last;
    double z;
    double slope;
};

/// The error, mm, that rounding may add when a triangle over z-map points of these heights is evaluated. Each
/// height of a run is Σ w_k z_k / A with weights and area that are whole numbers below 2⁵³, hence exact:
/// three products, two sums, a division and the step along the run, whose slope times its length stays below
/// 3 max|z|, err by less than 16 u max|z| (u = 2⁻⁵³). The same amount is added for a check of the result by
/// another formula, and the sum is doubled.
[[nodiscard]] inline double roundingGuard(std::span<const float> heights) {
    constexpr double kUnit = std::numeric_limits<double>::epsilon() / 2;
    double largest = 0;
    for (const float height : heights)
        largest = std::max(largest, std::abs(double{height}));
    return 64 * kUnit * largest;
}

/// Calls visit(LatticeRun) for each row of the points in the closed triangle, border points included; stops
/// and returns false if visit returns false. Rows that hold only a corner are skipped: corners are points of
/// the z-map, so the distance there is zero. Corners counter-clockwise, area positive.
template<class Visit>
bool scanTriangle(const LatticeCorner& a, const LatticeCorner& b, const LatticeCorner& c, Visit&& visit) {
    // Along a row, the height is (Σ w_k z_k) / area, where w_k is twice the area opposite corner k.
    const double area = (b.i - a.i) * (c.j - a.j) - (b.j - a.j) * (c.i - a.i);
    if (area == 1)
        return true; // by Pick's theorem it holds only its corners
    const double inverse = 1 / area;
    const double slope =
        ((b.j - c.j) * a.z + (c.j - a.j) * b.z + (a.j - b.j) * c.z) * inverse; // the weights grow by these
    const auto heightAt = [&](double i, double j) {
        const double wa = (b.i - i) * (c.j - j) - (b.j - j) * (c.i - i);
        const double wb = (c.i - i) * (a.j - j) - (c.j - j) * (a.i - i);
        const double wc = (a.i - i) * (b.j - j) - (a.j - j) * (b.i - i);
        return (wa * a.z + wb * b.z + wc * c.z) * inverse;
    };

    const LatticeCorner* low = &a;
    const LatticeCorner* middle = &b;
    const LatticeCorner* high = &c;
    if (middle->j < low->j)
        std::swap(low, middle);
    if (high->j < middle->j)
        std::swap(middle, high);
    if (middle->j < low->j)
        std::swap(low, middle);

    // Columns are counted from the leftmost corner, so that they are never negative and truncation rounds
    // down. An edge meets a row at a multiple of 1/(rows of the edge); the nudge is far below that, and far
    // above the rounding of the quotient.
    constexpr double kNudge = 0x1p-20;
    const double left = std::min({a.i, b.i, c.i});
    const double longStep = (high->i - low->i) / (high->j - low->j);
    const auto half = [&](const LatticeCorner& from, const LatticeCorner& to, double begin, double end) {
        const double rows = to.j - from.j;
        const double step = rows > 0 ? (to.i - from.i) / rows : 0;
        for (double j = begin; j < end; ++j) {
            const double one = (low->i - left) + (j - low->j) * longStep;
            const double other = (from.i - left) + (j - from.j) * step;
            const int first = static_cast<int>(std::min(one, other) + (1 - kNudge)) + static_cast<int>(left);
            const int last = static_cast<int>(std::max(one, other) + kNudge) + static_cast<int>(left);
            if (first > last)
                continue;
            const LatticeRun run{static_cast<int>(j), first, last, heightAt(first, j), slope};
            if (!visit(run))
                return false;
        }
        return true;
    };
    const bool topIsEdge = middle->j == high->j;
    return half(*low, *middle, low->j + 1, middle->j) &&
           half(*middle, *high, middle->j, topIsEdge ? high->j + 1 : high->j);
}

/// The heights of a region, row by row.
struct LatticeHeights {
    std::span<const float> values;
    std::size_t width;

    [[nodiscard]] const float* row(const LatticeRun& run) const {
        return values.data() + static_cast<std::size_t>(run.row) * width +
               static_cast<std::size_t>(run.first);
    }
};

/// Whether every point of a run is within `limit` of the triangle, vertically.
[[nodiscard]] inline bool runWithin(const LatticeHeights& heights, const LatticeRun& run, double limit) {
    const float* height = heights.row(run);
    const int count = run.last - run.first + 1;
    int beyond = 0; // accumulated without an early exit, so that the loop can be vectorized
    for (int k = 0; k < count; ++k) {
        const double distance = double{height[k]} - (run.z + run.slope * k);
        beyond |= static_cast<int>(distance > limit) | static_cast<int>(distance < -limit);
    }
    return beyond == 0;
}

/// The largest vertical distance of a point of a run.
[[nodiscard]] inline double runDistance(const LatticeHeights& heights, const LatticeRun& run) {
    const float* height = heights.row(run);
    const int count = run.last - run.first + 1;
    double largest = 0;
    for (int k = 0; k < count; ++k) {
        const double distance = double{height[k]} - (run.z + run.slope * k);
        largest = std::max(largest, distance < 0 ? -distance : distance);
    }
    return largest;
}

} // namespace proveout
