// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/sweep_passes.h"

#include <algorithm>
#include <cmath>

namespace proveout {

namespace {

/// Fitting leads costs about as much as solving these for some thousand points.
bool worthFitting(const ConvexProfile& profile, double length, const TileSpacing& spacing) {
    constexpr double kPoints = 10'000;
    return 2 * profile.rim * (length + profile.rim) >= kPoints * spacing.hx * spacing.hy;
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
        if (path.slope != 0 && worthFitting(profile, path.length, spacing))
            m_straight.back().fitLeads();
    }
}

SweepPasses::SweepPasses(std::span<const ConvexProfile> profiles, const ArcPath& path,
                         const TileSpacing& spacing) {
    const auto allSuffice = [&](const auto& suffices) {
        return std::ranges::all_of(
            profiles, [&](const ConvexProfile& profile) { return suffices(profile, path, spacing); });
    };
    if (allSuffice(RoundPass::suffices) && addRound(profiles, path))
        return;
    m_round.clear();
    if (allSuffice(CurvePass::suffices)) {
        for (const ConvexProfile& profile : profiles)
            m_curves.emplace_back(profile, path);
    }
}

bool SweepPasses::addRound(std::span<const ConvexProfile> profiles, const ArcPath& path) {
    for (const ConvexProfile& profile : profiles) {
        std::vector<RoundPass> parts = RoundPass::allOf(profile, path);
        if (path.climb != 0 && !RoundPass::fitLeads(parts))
            return false;
        std::ranges::move(parts, std::back_inserter(m_round));
    }
    return true;
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
    return m_curves.empty() ? static_cast<double>(m_straight.size() + m_round.size())
                            : kOfCurve * static_cast<double>(m_curves.size());
}

void SweepPasses::addOverTile(double x, double y, const TileSpacing& spacing,
                              std::vector<TilePass>& passes) const {
    for (const StraightPass& pass : m_straight)
        passes.push_back(pass.overTile(x, y, spacing));
    for (const RoundPass& pass : m_round)
        passes.push_back(pass.overTile(x, y, spacing));
    for (const CurvePass& curve : m_curves)
        curve.addOverTile(x, y, spacing, passes);
}

} // namespace proveout
