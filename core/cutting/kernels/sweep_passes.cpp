// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/kernels/sweep_passes.h"

#include <algorithm>
#include <cmath>

namespace proveout {

namespace {

bool reachesOver(double points, double rim, double length, const TileSpacing& spacing) {
    return 2 * rim * (length + rim) >= points * spacing.hx * spacing.hy;
}

/// Fitting leads costs about as much as solving them for some thousand points.
bool worthFitting(const ConvexProfile& profile, double length, const TileSpacing& spacing) {
    constexpr double kPoints = 10'000;
    return reachesOver(kPoints, profile.rim, length, spacing);
}

/// The leads of such a path are solved once per row or column of a block.
bool alongGrid(const StraightPath& path) {
    return path.along.x == 0 || path.along.y == 0;
}

/// Cutting the hollow as many lines instead costs more.
bool worthFitting(const HollowedProfiles& profiles, double length, const TileSpacing& spacing) {
    constexpr double kPoints = 2'000;
    const auto worth = [&](const HollowProfile& hollow) {
        return reachesOver(kPoints, hollow.below.rim, length, spacing);
    };
    return std::ranges::all_of(profiles.hollow, worth);
}

} // namespace

SweepPasses::SweepPasses(std::span<const ConvexProfile> profiles, const StraightPath& path,
                         const TileSpacing& spacing) {
    const auto suffices = [&](const ConvexProfile& profile) {
        return StraightPass::suffices(profile, path, spacing);
    };
    if (!std::ranges::all_of(profiles, suffices))
        return;
    for (const ConvexProfile& profile : profiles) {
        m_straight.emplace_back(profile, path);
        if (path.slope != 0 && !alongGrid(path) && worthFitting(profile, path.length, spacing))
            m_straight.back().fitLeads();
    }
}

SweepPasses::SweepPasses(std::span<const ConvexProfile> profiles, const ArcPath& path,
                         const TileSpacing& spacing) {
    const auto allSuffice = [&](const auto& suffices) {
        return std::ranges::all_of(
            profiles, [&](const ConvexProfile& profile) { return suffices(profile, path, spacing); });
    };
    if (allSuffice(RoundPass::suffices) && addRound<ConvexProfile>(profiles, path))
        return;
    m_round.clear();
    if (!profiles.empty() && allSuffice(CurvePass::suffices))
        m_curve.emplace(profiles, path);
}

template<class Profile>
bool SweepPasses::addRound(std::span<const Profile> profiles, const ArcPath& path) {
    for (const Profile& profile : profiles) {
        std::vector<RoundPass> parts = RoundPass::allOf(profile, path);
        if (path.climb != 0 && !RoundPass::fitLeads(parts))
            return false;
        std::ranges::move(parts, std::back_inserter(m_round));
    }
    return true;
}

bool SweepPasses::addStraight(std::span<const HollowProfile> profiles, const StraightPath& path) {
    return std::ranges::all_of(profiles, [&](const HollowProfile& hollow) {
        m_straight.emplace_back(hollow, path);
        return m_straight.back().fitLeads();
    });
}

SweepPasses::SweepPasses(const HollowedProfiles& profiles, const StraightPath& path,
                         const TileSpacing& spacing) {
    if (path.slope == 0 || path.length == 0 || !worthFitting(profiles, path.length, spacing))
        return;
    const auto suffices = [&](const HollowProfile& hollow) {
        return StraightPass::suffices(hollow.below, path, spacing);
    };
    if (!std::ranges::all_of(profiles.hollow, suffices))
        return;
    *this = SweepPasses(profiles.convex, path, spacing);
    if (!addStraight(profiles.hollow, path))
        *this = SweepPasses();
}

SweepPasses::SweepPasses(const HollowedProfiles& profiles, const ArcPath& path, const TileSpacing& spacing) {
    const auto suffices = [&](const ConvexProfile& profile) {
        return RoundPass::suffices(profile, path, spacing);
    };
    const auto belowSuffices = [&](const HollowProfile& hollow) { return suffices(hollow.below); };
    if (path.climb == 0) {
        if (path.normal != 2 && CurvePass::allSuffice(profiles, path, spacing))
            m_curve.emplace(profiles, path);
        return;
    }
    if (!std::ranges::all_of(profiles.convex, suffices) ||
        !std::ranges::all_of(profiles.hollow, belowSuffices))
        return;
    if (!addRound<ConvexProfile>(profiles.convex, path) || !addRound<HollowProfile>(profiles.hollow, path))
        m_round.clear();
}

SweepPasses::SweepPasses(const std::shared_ptr<const LevelProfile>& whole, const StraightPath& path,
                         const TileSpacing& spacing) {
    if (StraightPass::suffices(whole->below, path, spacing))
        m_straight.emplace_back(whole, path);
}

SweepPasses::SweepPasses(const std::shared_ptr<const LevelProfile>& whole, const ArcPath& path,
                         const TileSpacing& spacing) {
    if (RoundPass::suffices(whole->below, path, spacing))
        m_round = RoundPass::allOf(whole, path);
}

double SweepPasses::costOfPoint() const {
    constexpr double kOfCurve = 20; // measured: 100 ns against 5
    return m_curve ? kOfCurve * static_cast<double>(m_curve->profileCount())
                   : static_cast<double>(m_straight.size() + m_round.size());
}

void SweepPasses::addOverTile(double x, double y, const TileSpacing& spacing,
                              std::vector<TilePass>& passes) const {
    for (const StraightPass& pass : m_straight) {
        if (pass.reachesBeyondStart(x, y, spacing))
            passes.push_back(pass.overTile(x, y, spacing));
    }
    for (const RoundPass& pass : m_round)
        passes.push_back(pass.overTile(x, y, spacing));
    if (m_curve)
        m_curve->addOverTile(x, y, spacing, passes);
}

} // namespace proveout
