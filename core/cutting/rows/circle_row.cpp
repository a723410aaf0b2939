// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/rows/circle_row.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "core/cutting/profiles/profile_forms.h"
#include "core/cutting/profiles/vector_clones.h"

namespace proveout {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// One row relative to the centre of the circle. The path runs counter-clockwise from `begin` to `end`, as
/// seen from `begin`: a path in the other direction covers the same from its end.
struct Circle {
    double x;
    double step;
    double y;
    double radius;
    double z;
    double rim2;
    Vec2 begin;
    Vec2 end;
    double wide; ///< 1 if the path is longer than half a turn, else 0
    double closed;

    Circle(const ConvexProfile& profile, const ArcPath& path, const RowPoints& row)
        : x(row.x - path.centre.x), step(row.step), y(row.y - path.centre.y), radius(path.radius),
          z(path.centre.z), rim2(profile.rim * profile.rim) {
        const double gone = std::abs(path.sweep) * (path.end - path.begin);
        begin = Vec2(path.at(path.sweep > 0 ? path.begin : path.end)) - Vec2(path.centre);
        end = Vec2(path.at(path.sweep > 0 ? path.end : path.begin)) - Vec2(path.centre);
        wide = gone > std::numbers::pi ? 1 : 0;
        closed = gone >= 2 * std::numbers::pi * (1 - 1e-14) ? 1 : 0;
    }
};

double square(double value) {
    return value * value;
}

template<class Form>
[[gnu::always_inline]] inline void lowerPoints(const Form& form, const Circle& circle, Columns columns,
                                               float* out) {
    for (int k = columns.begin; k < columns.end; ++k) {
        const double x = circle.x + circle.step * k;
        const double y = circle.y;
        const double toCircle = std::sqrt(x * x + y * y) - circle.radius;
        const double toBegin2 = square(x - circle.begin.x) + square(y - circle.begin.y);
        const double toEnd2 = square(x - circle.end.x) + square(y - circle.end.y);
        // To the left of the spoke to the beginning and to the right of the one to the end; for more than
        // half a circle, one of both is enough. On the spokes all three distances agree, so rounding decides
        // nothing there.
        const double afterBegin = circle.begin.x * y - circle.begin.y * x >= 0 ? 1.0 : 0.0;
        const double beforeEnd = x * circle.end.y - y * circle.end.x >= 0 ? 1.0 : 0.0;
        const bool beside = afterBegin + beforeEnd + circle.wide + 2 * circle.closed >= 2;
        const double distance2 = beside ? toCircle * toCircle : lesser(toBegin2, toEnd2);
        const double z = circle.z + form.height(distance2);
        const auto cut = static_cast<float>(distance2 <= circle.rim2 ? z : kInfinity);
        out[k] = cut < out[k] ? cut : out[k];
    }
}

PROVEOUT_VECTOR_CLONES void lower(const FlatForm& form, const Circle& circle, Columns columns, float* out) {
    lowerPoints(form, circle, columns, out);
}
PROVEOUT_VECTOR_CLONES void lower(const LineForm& form, const Circle& circle, Columns columns, float* out) {
    lowerPoints(form, circle, columns, out);
}
PROVEOUT_VECTOR_CLONES void lower(const BallForm& form, const Circle& circle, Columns columns, float* out) {
    lowerPoints(form, circle, columns, out);
}
PROVEOUT_VECTOR_CLONES void lower(const CornerForm& form, const Circle& circle, Columns columns, float* out) {
    lowerPoints(form, circle, columns, out);
}

} // namespace

void circleRow(const ConvexProfile& profile, const ArcPath& path, const RowPoints& row, Columns columns,
               float* out) {
    const Circle circle(profile, path, row);
    withForm(profile, [&](const auto& form) { lower(form, circle, columns, out); });
}

} // namespace proveout
