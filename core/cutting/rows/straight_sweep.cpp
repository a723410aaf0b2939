// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/rows/straight_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace proveout {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Paths shorter than this over ground are plunges: their slope would use up the digits of a double, while
/// everything they could change is within this distance of the rim.
constexpr double kPlungeLength = 1e-10;

double squared(double value) {
    return value * value;
}

/// Square root of a value that may be below zero through rounding.
double rootOf(double value) {
    return std::sqrt(std::max(0.0, value));
}

/// The radius where the surface of a corner arc, on a path that falls by `fall`, touches lowest at `across`.
/// With r = centreR + radius·σ the stationary place satisfies σ²(r² - across²) = fall² r² (1 - σ²). As a
/// polynomial in σ its signs are + + ? - -, so it has one positive root, and it is convex to the right of
/// that root: Newton from any place to the right converges to the root without ever passing it.
double touchingRadius(const ConvexProfile& profile, double fall, double across) {
    const double ring = profile.centreR;
    const double corner = profile.radius;
    const double fall2 = fall * fall;
    const double across2 = across * across;
    const auto sine = [&](double r) {
        return fall * r / std::sqrt(std::max((r * r - across2) + fall2 * r * r, 1e-300));
    };
    // The fixed-point form σ = sine(ring + corner·σ) falls with σ: its value for the largest σ bounds the
    // root from below, and its value for that bound bounds the root from above.
    const double low = std::max(sine(ring + corner), (across - ring) / corner);
    double sigma = std::min(1.0, sine(ring + corner * low));
    for (int step = 0; step < 60; ++step) {
        const double r = ring + corner * sigma;
        const double reach = r * r - across2;
        const double value = sigma * sigma * reach - fall2 * r * r * (1 - sigma * sigma);
        const double rise = 2 * sigma * reach + 2 * corner * r * sigma * sigma -
                            2 * fall2 * corner * r * (1 - sigma * sigma) + 2 * fall2 * r * r * sigma;
        const double next = sigma - value / rise;
        if (!(next < sigma - 1e-15))
            break;
        sigma = next;
    }
    return ring + corner * sigma;
}

} // namespace

StraightPath straightPath(const Vec3& start, const Vec3& end) {
    const Vec2 over = Vec2(end) - Vec2(start);
    const double length = std::hypot(over.x, over.y);
    StraightPath path;
    if (length <= kPlungeLength) {
        const Vec3& lower = start.z < end.z ? start : end;
        path.from = Vec2(lower);
        path.z = lower.z;
        return path;
    }
    path.from = Vec2(start);
    path.along = over / length;
    path.length = length;
    path.z = start.z;
    path.slope = (end.z - start.z) / length;
    return path;
}

double lead(const ConvexProfile& profile, double fall, double across) {
    const double across2 = across * across;
    const double nearest = rootOf(squared(profile.flatTo) - across2);
    const double farthest = rootOf(squared(profile.rim) - across2);
    switch (profile.side) {
    case ConvexProfile::Side::none:
        return farthest;
    case ConvexProfile::Side::line:
        if (fall >= profile.slope)
            return farthest;
        return std::clamp(fall * across / std::sqrt((profile.slope - fall) * (profile.slope + fall)), nearest,
                          farthest);
    case ConvexProfile::Side::arc:
        break;
    }
    if (profile.centreR == 0)
        return std::clamp(rootOf(squared(profile.radius) - across2) * fall / std::sqrt(1 + fall * fall),
                          nearest, farthest);
    return std::clamp(rootOf(squared(touchingRadius(profile, fall, across)) - across2), nearest, farthest);
}

Contact lowestContact(const ConvexProfile& profile, const StraightPath& path, const Vec2& point) {
    const Vec2 to = point - path.from;
    const double s = to.x * path.along.x + to.y * path.along.y;
    const double w = std::abs(to.y * path.along.x - to.x * path.along.y);
    // The nearest place decides whether the cutter comes over the point: the lowest one may be exactly on the
    // rim, where rounding would decide.
    const double nearest = std::clamp(s, 0.0, path.length);
    if (!(squared(s - nearest) + w * w <= squared(profile.rim)))
        return {kInfinity, 0};
    double place = nearest;
    if (path.slope != 0 && path.length > 0) {
        const double ahead = lead(profile, std::abs(path.slope), w);
        place = std::clamp(path.slope < 0 ? s + ahead : s - ahead, 0.0, path.length);
    }
    const double distance = std::sqrt(squared(s - place) + w * w);
    return {path.z + path.slope * place + profile.height(distance), place};
}

namespace {

/// The interval of x where |offset + x·rate| and the like stay in [lo, hi].
Span linearSpan(double offset, double rate, double lo, double hi) {
    constexpr double kParallel = 1e-14;
    if (std::abs(rate) < kParallel)
        return offset >= lo && offset <= hi ? Span{-kInfinity, kInfinity} : Span{kInfinity, -kInfinity};
    const double a = (lo - offset) / rate;
    const double b = (hi - offset) / rate;
    return {std::min(a, b), std::max(a, b)};
}

void addDisc(Span& span, const Vec2& centre, double rim, double y) {
    const double up = y - centre.y;
    if (std::abs(up) > rim)
        return;
    const double half = std::sqrt(rim * rim - up * up);
    span.lo = std::min(span.lo, centre.x - half);
    span.hi = std::max(span.hi, centre.x + half);
}

} // namespace

Span rowSpan(const StraightPath& path, double rim, double y) {
    Span span{kInfinity, -kInfinity};
    addDisc(span, path.from, rim, y);
    if (path.length == 0)
        return span;
    addDisc(span, path.from + path.length * path.along, rim, y);
    const double up = y - path.from.y;
    const Span beside = linearSpan(up * path.along.x, -path.along.y, -rim, rim);
    const Span between = linearSpan(up * path.along.y, path.along.x, 0, path.length);
    const double lo = std::max(beside.lo, between.lo) + path.from.x;
    const double hi = std::min(beside.hi, between.hi) + path.from.x;
    if (lo <= hi)
        span = {std::min(span.lo, lo), std::max(span.hi, hi)};
    return span;
}

} // namespace proveout
