// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/kernels/round_pass.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace proveout {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;
/// A distance is computed from more numbers than on a straight path.
constexpr double kRimSlack = 5e-7;
constexpr double kBoundSlack = 4e-6;

constexpr double kLargestRadius = 1e5; ///< mm, of a path
constexpr double kSteepest = 4;        ///< mm per mm
constexpr double kMostClimb = 20;      ///< mm per radian
/// How much nearer a point may be to a spiral than to the circles that replace it, mm.
constexpr double kNearer = 1e-5;
/// Helices are split into parts of this angle, because bounds use the lowest height of a part for all of it.
constexpr double kPartOfHelix = kTurn / 4;

float toFloat(double value) {
    return static_cast<float>(value);
}

double least(const ArcPath& path) {
    return std::min(std::abs(path.radius), std::abs(path.radius + path.widening));
}

/// The angle of a part of a helix, radians. A helix that widens by w per radian is cut as parts of circles:
/// with a centre that is w beside its own, these deviate from it by w · θ³ / 6, and run ahead of it by w / R
/// · θ² / 2.
double mostOfHelix(const ArcPath& path) {
    const double perRadian = std::abs(path.widening / path.sweep);
    if (perRadian == 0)
        return kPartOfHelix;
    const double ahead = perRadian / least(path) * std::abs(path.climb / path.sweep);
    return std::min(
        {kPartOfHelix, 2 * std::cbrt(6 * kNearer / perRadian), 2 * std::sqrt(2 * kNearer / ahead)});
}

ArcPath circleLike(const ArcPath& path, double begin, double end) {
    const double middle = (begin + end) / 2;
    const double angle = path.angle + path.sweep * middle;
    const Vec3 from = path.at(begin);
    const Vec3 to = path.at(end);
    ArcPath circle = path;
    circle.begin = 0;
    circle.end = 1;
    circle.widening = 0;
    circle.centre += path.widening / path.sweep * Vec3(-std::sin(angle), std::cos(angle), 0);
    circle.centre.z = from.z;
    circle.climb = to.z - from.z;
    const Vec3 off = path.at(middle) - circle.centre;
    circle.radius = std::hypot(off.x, off.y);
    const auto angleTo = [&](const Vec3& place) {
        return std::atan2(place.y - circle.centre.y, place.x - circle.centre.x);
    };
    circle.angle = angleTo(from);
    circle.sweep = std::remainder(angleTo(to) - circle.angle, kTurn);
    return circle;
}

} // namespace

bool RoundPass::suffices(const ConvexProfile& profile, const ArcPath& path, const TileSpacing& spacing) {
    if (path.normal != 2 || !(std::abs(path.sweep) > 0))
        return false;
    const double radius = least(path);
    const double perRadian = 1 / std::abs(path.sweep);
    const double climb = std::abs(path.climb) * perRadian;
    const double aslant = std::abs(path.widening) * perRadian / radius;
    StraightPath like;
    like.slope = climb / radius;
    return path.radius > 0 && radius > 0 && radius <= kLargestRadius && climb <= kMostClimb &&
           like.slope <= kSteepest && 0.5 * aslant * aslant * profile.rim <= kNearer &&
           StraightPass::suffices(profile, like, spacing);
}

RoundPass::RoundPass(const ConvexProfile& profile, const ArcPath& path, double begin, double end)
    : m_centre(path.centre), m_rim(profile.rim) {
    const double middle = (begin + end) / 2;
    m_half = std::abs(path.sweep) * (end - begin) / 2;
    m_widening = path.widening / path.sweep;
    const double angle = path.angle + path.sweep * middle;
    const double climb = path.climb / path.sweep;
    StraightPath like;
    like.length = path.climb == 0 ? 0 : 1;
    m_towards = {std::cos(angle), std::sin(angle)};
    m_radius = path.radius + path.widening * middle;
    like.slope = m_slope = std::abs(climb) / m_radius;
    m_form = StraightPass::formOf(profile, like);
    m_form.path = TilePass::Path::round;
    m_z = path.centre.z + path.climb * middle + profile.reference();
    TilePass::Round& round = m_form.round;
    round.radius = toFloat(m_radius);
    round.widening = toFloat(m_widening);
    round.climb = toFloat(climb);
    round.half = toFloat(m_half);
    round.sine = toFloat(std::sin(m_half));
    round.cosine = toFloat(std::cos(m_half));
    round.lowest = toFloat(m_z - std::abs(climb) * m_half);
    round.spread = toFloat(std::abs(path.widening * (end - begin)) / 2);
    round.left = path.sweep < 0 ? 1.0F : -1.0F;
}

std::vector<RoundPass> RoundPass::allOf(const ConvexProfile& profile, const ArcPath& path) {
    const double angle = std::abs(path.sweep) * (path.end - path.begin);
    const double most = path.climb == 0 ? kTurn * (1 + 1e-12) : mostOfHelix(path);
    const int count = std::max(1, static_cast<int>(std::ceil(angle / most)));
    const bool asCircles = path.climb != 0 && path.widening != 0;
    std::vector<RoundPass> passes;
    for (int k = 0; k < count; ++k) {
        const int part = path.climb < 0 ? count - 1 - k : k;
        const auto at = [&](int of) {
            return std::lerp(path.begin, path.end, of / static_cast<double>(count));
        };
        if (asCircles)
            passes.emplace_back(profile, circleLike(path, at(part), at(part + 1)), 0, 1);
        else
            passes.emplace_back(profile, path, at(part), at(part + 1));
    }
    return passes;
}

std::vector<RoundPass> RoundPass::allOf(const std::shared_ptr<const LevelProfile>& whole,
                                        const ArcPath& path) {
    std::vector<RoundPass> passes = allOf(whole->below, path);
    for (RoundPass& pass : passes) {
        pass.m_form.form = TilePass::Form::whole;
        pass.m_form.whole = whole.get();
        pass.m_whole = whole;
    }
    return passes;
}

std::vector<RoundPass> RoundPass::allOf(const HollowProfile& hollow, const ArcPath& path) {
    std::vector<RoundPass> passes = allOf(hollow.below, path);
    for (RoundPass& pass : passes)
        setHollow(pass.m_form, hollow);
    return passes;
}

bool RoundPass::fitLeads(std::span<RoundPass> parts) {
    constexpr double kAlike = 5e-3; // as a fraction of the radius: heights depend on the square of the error
                                    // of leads
    const RoundPass* last = nullptr;
    for (RoundPass& part : parts) {
        if (last == nullptr || std::abs(part.m_radius - last->m_radius) > kAlike * last->m_radius) {
            TilePass pass = part.m_form;
            pass.rim2 = toFloat(part.m_rim * part.m_rim);
            part.m_bands = leadBands(pass);
            last = &part;
        }
        part.m_bands = last->m_bands;
        part.m_form.bands = part.m_bands.get();
        if (part.m_bands == nullptr)
            return false;
    }
    return true;
}

TilePass RoundPass::overTile(double x, double y, const TileSpacing& spacing) const {
    const Vec2 from = Vec2(x, y) - m_centre;
    const double along = from.x * m_towards.x + from.y * m_towards.y;
    const double across = from.y * m_towards.x - from.x * m_towards.y;
    const double size = m_rim + spacing.tileReach;
    const double padded = m_rim + kRimSlack * size;
    TilePass pass = m_form;
    TilePass::Round& round = pass.round;
    const double spread = static_cast<double>(round.spread);
    const double reach = padded + spread + spacing.blockReach * (1 + 1e-5);
    pass.alongX = toFloat(spacing.hx * m_towards.x);
    pass.alongY = toFloat(spacing.hy * m_towards.y);
    pass.acrossX = toFloat(-spacing.hx * m_towards.y);
    pass.acrossY = toFloat(spacing.hy * m_towards.x);
    pass.z = toFloat(m_z);
    pass.rim2 = toFloat(padded * padded);
    pass.reach2 = toFloat(reach * reach);
    pass.slack = toFloat(kBoundSlack * (size * (1 + m_slope) + std::abs(m_z)));
    round.middleAlong = toFloat(along);
    round.middleAcross = toFloat(across);
    // In double, because near the path it is a difference of large numbers.
    round.excess = toFloat(along * along + across * across - m_radius * m_radius);
    const auto end = [&](double side, float& endAlong, float& endAcross) {
        const double angle = side * m_half;
        const double radius = m_radius + m_widening * angle;
        endAlong = toFloat(radius * std::cos(angle) - along);
        endAcross = toFloat(radius * std::sin(angle) - across);
    };
    end(-1, round.beginAlong, round.beginAcross);
    end(1, round.endAlong, round.endAcross);
    round.blockReach = toFloat(spacing.blockReach * (1 + 1e-5));
    return pass;
}

} // namespace proveout
