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
        : m_zmap(before), m_surface(surface), m_prepared(surface, motion, before),
          m_trial(before, m_prepared), m_moments(moments), m_profiles(convexProfiles(surface, 0)) {}

    /// Nothing if it was stopped.
    std::optional<PartContact> run(const std::stop_token& stop) {
        if (m_prepared.sweep.empty())
            return m_deepest;
        for (const auto& [height, tile] : tilesByHeight()) {
            if (stop.stop_requested())
                return std::nullopt;
            // Bounds are not always the same for the same heights, and rounded in another way than depths.
            if (static_cast<double>(m_zmap.tile(tile).maximum) - height > atLeast() - kAlike / 2)
                m_trial.lower(tile, [&](int i, int j, float before, float lowered) {
                    consider(i, j, static_cast<double>(before), static_cast<double>(lowered));
                });
        }
        return m_deepest;
    }

private:
    /// A contact counts as deeper only if it is by this, so that the place of one among many of the same
    /// depth does not depend on the bounds of tiles, which depend on how the map was cut.
    static constexpr double kAlike = 1e-4;

    /// Contacts that are not deeper than this one do not matter.
    [[nodiscard]] double atLeast() const { return std::max(m_deepest.depth + kAlike, ToolAssembly::kExact); }

    /// The tiles that the part may touch, each with the lowest height that it may have there: lowest first,
    /// because it is probably deepest there.
    [[nodiscard]] std::vector<std::pair<double, std::size_t>> tilesByHeight() const {
        std::vector<std::size_t> tiles;
        tilesToLower(m_zmap, m_prepared.sweep, tiles);
        std::vector<std::pair<double, std::size_t>> heights;
        heights.reserve(tiles.size());
        for (const std::size_t tile : tiles)
            heights.emplace_back(lowestOver(tile), tile);
        std::ranges::sort(heights);
        return heights;
    }

    /// As if the tip were at its lowest where it is nearest to the tile.
    [[nodiscard]] double lowestOver(std::size_t tile) const {
        const Grid& grid = m_zmap.grid();
        const IndexRect rect = m_zmap.tileRect(tile);
        const Vec2 lo(grid.x(rect.i0), grid.y(rect.j0));
        const Vec2 hi(grid.x(rect.i1 - 1), grid.y(rect.j1 - 1));
        const Sweep& sweep = m_prepared.sweep;
        const Vec2 beside = glm::max(lo - Vec2(sweep.reach().hi), Vec2(sweep.reach().lo) - hi);
        const Vec2 fromPath = glm::max(beside + m_surface.radius(), Vec2(0));
        const double nearest = std::min(glm::length(fromPath), m_surface.radius());
        return sweep.lowest() + m_surface.height(nearest) - m_surface.height(0);
    }

    /// A point at which the part would meet the stock if the cutter removed nothing.
    void consider(int i, int j, double height, double lowered) {
        if (height - lowered <= atLeast())
            return;
        const Vec2 point(m_zmap.grid().x(i), m_zmap.grid().y(j));
        const double topZ = m_zmap.stock().topZ();
        const std::optional<double> depth =
            m_moments.deepest(m_profiles, m_surface.radius(), point, topZ + height);
        const double exact = depth.value_or(height - lowered);
        if (exact > atLeast())
            m_deepest = {exact, Vec3(point, topZ + height - exact)};
    }

    const ZMap& m_zmap;
    const Cutter& m_surface;
    PreparedSweep m_prepared;
    TileTrial m_trial;
    MomentsOverPoint& m_moments;
    std::vector<ConvexProfile> m_profiles;
    PartContact m_deepest;
};

} // namespace

ToolAssembly::ToolAssembly(const Cutter& cutter, double clearance, double aside)
    : m_cutterRadius(cutter.radius()), m_lowest(std::numeric_limits<double>::infinity()) {
    add(shankProfile(cutter), clearance + aside, clearance, cutter.profileHeight(), &AssemblyContact::shank);
    add(holderProfile(cutter), clearance + aside, clearance, cutter.profileHeight(),
        &AssemblyContact::holder);
    if (!empty())
        m_cutter = convexProfiles(cutter, 0);
}

void ToolAssembly::add(std::vector<ProfilePiece> pieces, double outwards, double downwards, double lowest,
                       PartContact AssemblyContact::*contact) {
    if (pieces.empty())
        return;
    const double down = std::min(downwards, pieces.front().z0 - lowest);
    for (ProfilePiece& piece : pieces) {
        piece.r0 += piece.r0 > 0 ? outwards : 0;
        piece.r1 += outwards;
        piece.z0 -= down;
        piece.z1 -= down;
    }
    m_lowest = std::min(m_lowest, pieces.front().z0);
    m_parts.push_back({Cutter("", CutterProfile{std::move(pieces), {}}), contact});
}

double ToolAssembly::radius() const {
    double largest = 0;
    for (const Part& part : m_parts)
        largest = std::max(largest, part.surface.radius());
    return largest;
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
