// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/solid/wall_caps.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>

namespace proveout {

namespace {

/// Triangles that are flatter than this, as a fraction of a cell, have no area; up to the other they may be
/// turned over.
constexpr double kNoArea = 1e-4;
constexpr double kTurned = 0.2;
/// A flip may leave another cap beside it; long chains of them were not seen.
constexpr int kMostRounds = 8;

class WallCaps {
public:
    WallCaps(const SolidFrame& frame, std::vector<LatticeTriangle>& surface)
        : m_frame(frame), m_surface(surface),
          m_cell(std::max(frame.zmap().grid().hx, frame.zmap().grid().hy)) {
        for (std::size_t t = 0; t < surface.size(); ++t) {
            const auto walls =
                std::ranges::count_if(surface[t], [&](auto vertex) { return frame.isBesideWall(vertex); });
            if (walls < 2)
                continue;
            link(t);
            if (walls == 3)
                m_onWalls.push_back(t);
        }
    }

    void flipAll() {
        bool flipped = true;
        for (int round = 0; flipped && round < kMostRounds; ++round) {
            flipped = false;
            for (const std::size_t t : m_onWalls)
                flipped = flipIfCap(t) || flipped;
        }
    }

private:
    [[nodiscard]] static std::uint64_t key(std::uint32_t from, std::uint32_t to) {
        return std::uint64_t{from} << 32U | to;
    }
    void link(std::size_t t) {
        for (std::size_t k = 0; k < 3; ++k)
            m_triangleAt[key(m_surface[t][k], m_surface[t][(k + 1) % 3])] = t;
    }

    /// The side opposite the middle point of a triangle that is a cap, by its first corner.
    [[nodiscard]] std::optional<std::size_t> longSideOfCap(std::size_t t) const {
        const std::array corners{m_frame.top(m_surface[t][0]), m_frame.top(m_surface[t][1]),
                                 m_frame.top(m_surface[t][2])};
        const Vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        std::size_t longest = 0;
        double length = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const double side = glm::length(corners[(k + 1) % 3] - corners[k]);
            if (side > length) {
                length = side;
                longest = k;
            }
        }
        const double flatness = length > 0 ? glm::length(normal) / length : 0;
        const bool turned = normal.z < -0.5 * glm::length(normal) && flatness < kTurned * m_cell;
        return flatness < kNoArea * m_cell || turned ? std::optional(longest) : std::nullopt;
    }

    bool flipIfCap(std::size_t t) {
        const auto side = longSideOfCap(t);
        if (!side)
            return false;
        const std::uint32_t a = m_surface[t][*side];
        const std::uint32_t c = m_surface[t][(*side + 1) % 3];
        const std::uint32_t b = m_surface[t][(*side + 2) % 3];
        const auto beyond = m_triangleAt.find(key(c, a));
        if (beyond == m_triangleAt.end())
            return false; // the border of the map
        const std::size_t other = beyond->second;
        const auto isThird = [&](std::uint32_t vertex) { return vertex != a && vertex != c; };
        const std::uint32_t d = *std::ranges::find_if(m_surface[other], isThird);
        if (m_triangleAt.contains(key(b, d)) || m_triangleAt.contains(key(d, b)))
            return false; // that edge exists elsewhere
        m_triangleAt.erase(key(a, c));
        m_triangleAt.erase(key(c, a));
        m_surface[t] = {a, d, b};
        m_surface[other] = {d, c, b};
        link(t);
        link(other);
        return true;
    }

    const SolidFrame& m_frame;
    std::vector<LatticeTriangle>& m_surface;
    double m_cell;
    std::unordered_map<std::uint64_t, std::size_t> m_triangleAt; ///< by the edge that leads around it
    std::vector<std::size_t> m_onWalls;                          ///< triangles with three points on walls
};

} // namespace

void flipWallCaps(const SolidFrame& frame, std::vector<LatticeTriangle>& surface) {
    WallCaps(frame, surface).flipAll();
}

} // namespace proveout
