// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/cut/assembly_contact.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "core/cutter/body_profiles.h"
#include "core/cutting/cut/lower_tile.h"
#include "core/cutting/cut/moments_over_point.h"
#include "core/cutting/cut/tile_trial.h"
#include "core/cutting/cut/tiles_under.h"

namespace proveout {

namespace {

/// The search for the deepest contact of one part.
class Search {
public:
    Search(const ZMap& before, const Cutter& surface, const Motion& motion, MomentsOverPoint& moments)
        : m_zmap(before), m_prepared(surface, motion, before), m_trial(before, m_prepared),
          m_moments(moments), m_profiles(convexProfiles(surface, 0)), m_radius(surface.radius()) {}

    /// Nothing if it was stopped.
    std::optional<PartContact> run(const std::stop_token& stop) {
        if (m_prepared.sweep.empty())
            return m_deepest;
        std::vector<std::size_t> tiles;
        tilesToLower(m_zmap, m_prepared.sweep, tiles);
        for (const std::size_t tile : tiles) {
            if (stop.stop_requested())
                return std::nullopt;
            const double most = static_cast<double>(m_zmap.tile(tile).maximum) - m_prepared.sweep.lowest();
            if (most > atLeast())
                m_trial.lower(tile, [&](int i, int j, float height, float lowered) {
                    consider(i, j, static_cast<double>(height), static_cast<double>(lowered));
                });
        }
        return m_deepest;
    }

private:
    /// Contacts that are not deeper than this one do not matter.
    [[nodiscard]] double atLeast() const { return std::max(m_deepest.depth, ToolAssembly::kExact); }

    /// A point at which the part would meet the stock if the cutter removed nothing.
    void consider(int i, int j, double height, double lowered) {
        if (height - lowered <= atLeast())
            return;
        const Vec2 point(m_zmap.grid().x(i), m_zmap.grid().y(j));
        const double topZ = m_zmap.stock().topZ();
        const std::optional<double> depth = m_moments.deepest(m_profiles, m_radius, point, topZ + height);
        const double exact = depth.value_or(height - lowered);
        if (exact > atLeast())
            m_deepest = {exact, Vec3(point, topZ + height - exact)};
    }

    const ZMap& m_zmap;
    PreparedSweep m_prepared;
    TileTrial m_trial;
    MomentsOverPoint& m_moments;
    std::vector<ConvexProfile> m_profiles;
    double m_radius;
    PartContact m_deepest;
};

} // namespace

void PartContact::add(const PartContact& other) {
    if (other.depth > depth)
        *this = other;
}

ToolAssembly::ToolAssembly(const Cutter& cutter, double clearance)
    : m_cutterRadius(cutter.radius()), m_lowest(std::numeric_limits<double>::infinity()) {
    add(shankProfile(cutter), clearance, cutter.profileHeight(), &AssemblyContact::shank);
    add(holderProfile(cutter), clearance, cutter.profileHeight(), &AssemblyContact::holder);
    if (!empty())
        m_cutter = convexProfiles(cutter, 0);
}

void ToolAssembly::add(std::vector<ProfilePiece> pieces, double clearance, double lowest,
                       PartContact AssemblyContact::*contact) {
    if (pieces.empty())
        return;
    const double down = std::min(clearance, pieces.front().z0 - lowest);
    for (ProfilePiece& piece : pieces) {
        piece.r0 += piece.r0 > 0 ? clearance : 0;
        piece.r1 += clearance;
        piece.z0 -= down;
        piece.z1 -= down;
    }
    m_lowest = std::min(m_lowest, pieces.front().z0);
    m_parts.push_back({Cutter("", CutterProfile{std::move(pieces), {}}), contact});
}

bool ToolAssembly::staysAbove(const StockBox& stock, const Motion& motion) const {
    return empty() || bounds(motion).lo.z + m_lowest >= stock.topZ();
}

std::optional<AssemblyContact> ToolAssembly::contact(const ZMap& before, const Motion& motion,
                                                     const std::stop_token& stop) const {
    AssemblyContact found;
    if (staysAbove(before.stock(), motion))
        return found;
    MomentsOverPoint moments(m_cutter, m_cutterRadius, motion, before.stock().floorZ());
    for (const Part& part : m_parts) {
        const auto deepest = Search(before, part.surface, motion, moments).run(stop);
        if (!deepest)
            return std::nullopt;
        found.*part.contact = *deepest;
    }
    return found;
}

} // namespace proveout
