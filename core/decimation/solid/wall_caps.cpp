// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/solid/wall_caps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "core/decimation/solid/corners.h"
#include "core/decimation/solid/creases.h"

namespace proveout {

namespace {

/// Triangles that are flatter than this, as a fraction of a cell, have no area.
constexpr double kNoArea = 1e-4;
/// Walls are thinner in plan, as a fraction of a cell.
constexpr double kWall = 0.1;
/// Three points of one edge of a wall are flatter than this, as a fraction of a cell.
constexpr double kCap = 0.2;
/// How far from the plane of the triangle beyond a side a point may be that is given to it, as a fraction of
/// a cell.
constexpr double kBesidePlane = 0.2;
/// A fold that may be left in place of a fin is flatter than this, as a fraction of a cell.
constexpr double kLittleFold = 0.05;
/// A flip may leave another triangle to flip beside it, as along a straight wall that many points are on.
constexpr int kMostRounds = 64;

class WallCaps {
public:
    WallCaps(const SolidFrame& frame, std::vector<LatticeTriangle>& surface)
        : m_frame(frame), m_surface(surface), m_cell(frame.cell()) {
        std::vector<bool> isNear(frame.points());
        for (std::size_t t = 0; t < surface.size(); ++t) {
            if (!frame.isBesideWall(surface[t]))
                continue;
            m_toLookAt.push_back(t);
            for (const std::uint32_t point : surface[t])
                isNear[point] = true;
        }
        m_triangleAt.reserve(4 * m_toLookAt.size()); // three edges, and some more triangles
        for (std::size_t t = 0; t < surface.size(); ++t) {
            if (std::ranges::any_of(surface[t], [&](auto point) { return isNear[point]; }))
                link(t);
        }
    }

    [[nodiscard]] FormerTriangles flipAll() {
        bool flipped = true;
        for (int round = 0; flipped && round < kMostRounds; ++round) {
            flipped = false;
            for (const std::size_t t : std::exchange(m_toLookAt, {}))
                flipped = look(t) || flipped;
        }
        return std::move(m_former);
    }

private:
    /// A side of a triangle, with what is beyond it: the points of both triangles are a, b, c and c, a, d.
    struct Side {
        std::uint32_t a, b, c, d;
        std::size_t beyond;
    };

    [[nodiscard]] static std::uint64_t key(std::uint32_t from, std::uint32_t to) {
        return std::uint64_t{from} << 32U | to;
    }
    void link(std::size_t t) {
        for (std::size_t k = 0; k < 3; ++k)
            m_triangleAt[key(m_surface[t][k], m_surface[t][(k + 1) % 3])] = t;
    }

    [[nodiscard]] bool isGood(const Corners& corners) const {
        return flatness(corners) > kNoArea * m_cell && !isTurnedOver(corners);
    }

    /// Nothing at the border of the map, if the flip would make an edge that exists elsewhere, or one that
    /// was flipped already: two rules could go on for ever.
    [[nodiscard]] std::optional<Side> side(std::size_t t, std::size_t k) const {
        const std::uint32_t a = m_surface[t][k];
        const std::uint32_t c = m_surface[t][(k + 1) % 3];
        const std::uint32_t b = m_surface[t][(k + 2) % 3];
        const auto beyond = m_triangleAt.find(key(c, a));
        if (beyond == m_triangleAt.end())
            return std::nullopt;
        const auto isThird = [&](std::uint32_t vertex) { return vertex != a && vertex != c; };
        const std::uint32_t d = *std::ranges::find_if(m_surface[beyond->second], isThird);
        if (m_frame.onOutline(b) && m_frame.onOutline(d))
            return std::nullopt;
        const bool exists = m_triangleAt.contains(key(b, d)) || m_triangleAt.contains(key(d, b));
        if (exists || m_flipped.contains(key(b, d)) || m_flipped.contains(key(d, b)))
            return std::nullopt;
        return Side{a, b, c, d, beyond->second};
    }

    /// How far the middle point is from the plane of the triangle beyond a side.
    [[nodiscard]] double besidePlane(const Side& side) const {
        const Corners beyond = m_frame.top({side.c, side.a, side.d});
        const Vec3 normal = normalOf(beyond);
        const double size = glm::length(normal);
        return size > 0 ? std::abs(glm::dot(normal, m_frame.top(side.b) - beyond[0])) / size : 0;
    }

    /// Flips it if needed. What was flipped, or could not be, is looked at once more in the next round.
    bool look(std::size_t t) {
        const Corners corners = m_frame.top(m_surface[t]);
        std::optional<Side> way;
        if (isGood(corners)) {
            if (isOnWalls(m_surface[t]) && !isWallOrLevel(corners))
                way = sideOfWall(t);
            const bool leadsAcross = !way && (isAcross(m_surface[t]) || isFin(m_surface[t]));
            if (leadsAcross)
                way = sideOfCrease(t);
            if (!way && !leadsAcross)
                return false;
        } else if (isOnWalls(m_surface[t]) && flatness(corners) < kCap * m_cell) {
            way = longSide(t, corners);
        } else {
            way = sideInPlane(t);
        }
        m_toLookAt.push_back(t);
        if (way)
            flip(t, *way);
        return way.has_value();
    }

    [[nodiscard]] bool isOnWalls(const LatticeTriangle& triangle) const {
        return std::ranges::all_of(triangle, [&](auto point) { return m_frame.isBesideWall(point); });
    }
    [[nodiscard]] bool isWallOrLevel(const Corners& corners) const {
        if (isLevel(corners))
            return true;
        Corners plan = corners;
        for (Vec3& corner : plan)
            corner.z = 0;
        return flatness(plan) < kWall * m_cell;
    }

    /// Where two walls meet in a cell, the diagonal of the mesh may lead through the corner from the top of
    /// one wall to the bottom of the other.
    [[nodiscard]] std::optional<Side> sideOfWall(std::size_t t) const {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::optional<Side> way = side(t, k);
            if (!way)
                continue;
            const auto isRight = [&](const LatticeTriangle& triangle) {
                const Corners corners = m_frame.top(triangle);
                return isGood(corners) && isWallOrLevel(corners) && !isAcross(triangle);
            };
            if (isRight({way->a, way->d, way->b}) && isRight({way->d, way->c, way->b}))
                return way;
        }
        return std::nullopt;
    }

    /// A long one, which had no area beyond the crease before one of its points moved onto that.
    [[nodiscard]] bool isAcross(const LatticeTriangle& triangle) const {
        const auto uphill = [&](std::size_t k) { return m_frame.wallNormal(triangle[k]); };
        return isAcrossCrease(m_frame.top(triangle), {uphill(0), uphill(1), uphill(2)}, m_cell);
    }

    /// A wall that leads away from the walls: the points above and below a wall, which have met in plan, with
    /// one far away.
    [[nodiscard]] bool isFin(const LatticeTriangle& triangle) const {
        constexpr double kUpright = 0.05;
        const Corners corners = m_frame.top(triangle);
        const Vec3 normal = normalOf(corners);
        return !isOnWalls(triangle) && std::abs(normal.z) < kUpright * glm::length(normal) &&
               hasFoot(corners);
    }
    /// Whether two corners of it are above each other.
    [[nodiscard]] bool hasFoot(const Corners& corners) const {
        constexpr double kNear = 0.01; // of a cell
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 side = corners[(k + 1) % 3] - corners[k];
            if (glm::length(Vec2(side)) < kNear * m_cell && std::abs(side.z) > kNear * m_cell)
                return true;
        }
        return false;
    }

    [[nodiscard]] std::optional<Side> sideOfCrease(std::size_t t) const {
        const bool isOfFin = isFin(m_surface[t]);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::optional<Side> way = side(t, k);
            const auto isRight = [&](const LatticeTriangle& triangle) {
                const Corners corners = m_frame.top(triangle);
                const double flat = flatness(corners) / m_cell;
                if (isOfFin && isLevel(corners) && flat > kNoArea && flat < kLittleFold)
                    return true; // if it is turned over, it can be unfolded
                return isGood(corners) && !isAcross(triangle) && !isFin(triangle);
            };
            if (way && isRight({way->a, way->d, way->b}) && isRight({way->d, way->c, way->b}))
                return way;
        }
        return std::nullopt;
    }

    /// That of a cap, if one cap less is left then, or two with shorter sides.
    [[nodiscard]] std::optional<Side> longSide(std::size_t t, const Corners& corners) const {
        const std::optional<Side> way = side(t, longestSide(corners));
        if (!way)
            return std::nullopt;
        const LatticeTriangle& beyond = m_surface[way->beyond];
        const Corners ofBeyond = m_frame.top(beyond);
        if (isGood(ofBeyond))
            return way;
        const std::uint32_t from = beyond[longestSide(ofBeyond)];
        const std::uint32_t to = beyond[(longestSide(ofBeyond) + 1) % 3];
        return from == way->c && to == way->a ? way : std::nullopt; // else it is flipped first
    }

    /// The flip that leaves two good triangles and the surface nearest to what it was.
    [[nodiscard]] std::optional<Side> sideInPlane(std::size_t t) const {
        std::optional<Side> best;
        double least = kBesidePlane * m_cell;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::optional<Side> way = side(t, k);
            const auto isRight = [&](const LatticeTriangle& triangle) {
                return isGood(m_frame.top(triangle)) && !isFin(triangle);
            };
            if (!way || !isRight({way->a, way->d, way->b}) || !isRight({way->d, way->c, way->b}))
                continue;
            const double beside = besidePlane(*way);
            if (beside < least) {
                least = beside;
                best = way;
            }
        }
        return best;
    }

    void flip(std::size_t t, const Side& side) {
        const auto& [a, b, c, d, beyond] = side;
        m_triangleAt.erase(key(a, c));
        m_triangleAt.erase(key(c, a));
        m_flipped.insert(key(a, c));
        m_former.emplace_back(t, m_surface[t]);
        m_former.emplace_back(beyond, m_surface[beyond]);
        m_surface[t] = {a, d, b};
        m_surface[beyond] = {d, c, b};
        link(t);
        link(beyond);
        m_toLookAt.push_back(beyond);
    }

    const SolidFrame& m_frame;
    std::vector<LatticeTriangle>& m_surface;
    double m_cell;
    std::unordered_map<std::uint64_t, std::size_t> m_triangleAt; ///< by the edge that leads around it
    std::unordered_set<std::uint64_t> m_flipped;                 ///< edges
    std::vector<std::size_t> m_toLookAt;
    FormerTriangles m_former;
};

} // namespace

FormerTriangles flipWallCaps(const SolidFrame& frame, std::vector<LatticeTriangle>& surface) {
    return WallCaps(frame, surface).flipAll();
}

} // namespace proveout
