// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/cutting/oracle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace proveout {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kRimMask = 2e-5; // near walls, a micrometre in plan is many in height

/// The formula of each shape would be more independent; Cutter::height is checked against those in
/// cutter_test.
double heightOver(const Cutter& cutter, double distance) {
    return distance <= cutter.radius() ? cutter.height(distance) : kInfinity;
}

/// Golden section search on a triple a < m < b with f(m) not above f(a) and f(b); infinite values count as
/// high.
template<class Function>
double refine(const Function& f, double a, double m, double b) {
    constexpr double kGolden = 0.381966011250105;
    double best = f(m);
    for (int step = 0; step < 60 && b - a > 1e-14; ++step) {
        const bool right = b - m > m - a;
        const double probe = right ? m + kGolden * (b - m) : m - kGolden * (m - a);
        const double value = f(probe);
        if (value < best) {
            (right ? a : b) = m;
            m = probe;
            best = value;
        } else {
            (right ? b : a) = probe;
        }
    }
    return m;
}

/// The radii at which the profile is vertical.
std::vector<double> wallsOf(const Cutter& cutter) {
    std::vector<double> walls = {cutter.radius()};
    const auto& pieces = cutter.pieces();
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const ProfilePiece& piece = pieces[k];
        if (piece.kind == PieceKind::arc && piece.centreR + piece.radius - piece.r1 < kRimMask)
            walls.push_back(piece.r1);
        if (piece.kind == PieceKind::upperArc && piece.r0 - (piece.centreR - piece.radius) < kRimMask)
            walls.push_back(piece.r0);
        if (k > 0 && piece.z0 > pieces[k - 1].z1)
            walls.push_back(piece.r0);
    }
    return walls;
}

/// A position on the path, relative to the point.
struct Place {
    double t;
    double distance;
    double height; ///< of the cutter over the point
};

/// The search over one path for one point.
class Search {
public:
    Search(const Cutter& cutter, const OraclePath& path, double x, double y)
        : m_cutter(cutter), m_path(path), m_x(x), m_y(y) {
        const auto count = path.samples().size();
        m_places.reserve(count + 16);
        for (std::size_t k = 0; k < count; ++k)
            m_places.push_back(
                seen(static_cast<double>(k) / static_cast<double>(count - 1), path.samples()[k]));
    }

    OracleHeight run() {
        const bool onRim = addNearest();
        addCrossings();
        return {lowest(), onRim};
    }

private:
    [[nodiscard]] Place seen(double t, const Vec3& tip) const {
        const double distance = std::hypot(tip.x - m_x, tip.y - m_y);
        return {t, distance, tip.z + heightOver(m_cutter, distance)};
    }
    [[nodiscard]] Place at(double t) const { return seen(t, m_path.at(t)); }

    void add(const std::vector<Place>& places) {
        m_places.insert(m_places.end(), places.begin(), places.end());
        std::ranges::sort(m_places, {}, &Place::t);
        const auto twice = std::ranges::unique(m_places, {}, &Place::t);
        m_places.erase(twice.begin(), twice.end());
    }

    /// Adds the local minima of the distance. Returns whether one of them is at a wall.
    bool addNearest() {
        const std::vector<double> walls = wallsOf(m_cutter);
        const auto atWall = [&](const Place& place) {
            return std::ranges::any_of(
                walls, [&](double wall) { return std::abs(place.distance - wall) < kRimMask; });
        };
        const auto distance = [&](double t) { return at(t).distance; };
        const std::size_t last = m_places.size() - 1;
        bool onRim = false;
        std::vector<Place> nearest;
        for (std::size_t k = 0; k <= last; ++k) {
            const Place& place = m_places[k];
            if ((k > 0 && m_places[k - 1].distance <= place.distance) ||
                (k < last && m_places[k + 1].distance < place.distance))
                continue;
            // A minimum may be next to an end.
            const double a = k > 0 ? m_places[k - 1].t : 0;
            const double b = k < last ? m_places[k + 1].t : 1;
            nearest.push_back(at(refine(distance, a, k == 0 || k == last ? (a + b) / 2 : place.t, b)));
            onRim = onRim || atWall(nearest.back()) || atWall(place);
        }
        onRim = onRim || atWall(m_places.front()) || atWall(m_places.back());
        add(nearest);
        return onRim;
    }

    /// The positions at which the point passes to another piece of the profile, on both sides, and some
    /// around them.
    void addCrossings() {
        std::vector<Place> crossings;
        for (std::size_t k = 0; k + 1 < m_places.size(); ++k) {
            for (const ProfilePiece& piece : m_cutter.pieces()) {
                const bool first = m_places[k].distance <= piece.r1;
                if (first == (m_places[k + 1].distance <= piece.r1))
                    continue;
                Place inside = m_places[first ? k : k + 1];
                double outside = m_places[first ? k + 1 : k].t;
                for (int step = 0; step < 60; ++step) {
                    const Place middle = at((inside.t + outside) / 2);
                    if (middle.distance <= piece.r1)
                        inside = middle;
                    else
                        outside = middle.t;
                }
                crossings.push_back(inside);
                crossings.push_back(at(outside));
                // Beyond a wall the height may fall to another minimum before the next sample.
                for (const std::size_t side : {k, k + 1})
                    for (const double part : {0.25, 0.5, 0.75})
                        crossings.push_back(at(inside.t + part * (m_places[side].t - inside.t)));
            }
        }
        add(crossings);
    }

    [[nodiscard]] double lowest() const {
        const auto height = [&](double t) { return at(t).height; };
        const std::size_t last = m_places.size() - 1;
        double best = kInfinity;
        for (std::size_t k = 0; k <= last; ++k) {
            const Place& place = m_places[k];
            best = std::min(best, place.height);
            if (place.height == kInfinity || (k > 0 && m_places[k - 1].height < place.height) ||
                (k < last && m_places[k + 1].height < place.height))
                continue;
            // The first position of a level part is sufficient.
            if (k > 1 && m_places[k - 1].height == place.height && m_places[k - 2].height == place.height)
                continue;
            best = std::min(best, height(refine(height, m_places[k > 0 ? k - 1 : k].t, place.t,
                                                m_places[k < last ? k + 1 : k].t)));
        }
        return best;
    }

    const Cutter& m_cutter;
    const OraclePath& m_path;
    double m_x;
    double m_y;
    std::vector<Place> m_places; ///< ascending
};

struct ArcAxes {
    int u;
    int v;
    int n;
};

ArcAxes arcAxes(const Motion& motion) {
    static constexpr std::array<ArcAxes, 3> kAxes = {{{0, 1, 2}, {2, 0, 1}, {1, 2, 0}}};
    return kAxes[static_cast<std::size_t>(motion.plane)];
}

} // namespace

OraclePath::OraclePath(const Motion& motion, int samples) : m_motion(motion) {
    const auto [u, v, n] = arcAxes(motion);
    const Vec3 start = motion.start - motion.centre;
    const Vec3 end = motion.end - motion.centre;
    m_radius = std::hypot(start[u], start[v]);
    m_widening = std::hypot(end[u], end[v]) - m_radius;
    m_angle = std::atan2(start[v], start[u]);
    for (int k = 0; k <= samples; ++k)
        m_samples.push_back(at(samples > 0 ? static_cast<double>(k) / samples : 0));
}

Vec3 OraclePath::at(double t) const {
    if (m_motion.kind != MotionKind::arc)
        return m_motion.start + t * (m_motion.end - m_motion.start);
    const auto [u, v, n] = arcAxes(m_motion);
    const double r = m_radius + t * m_widening;
    const double angle = m_angle + t * m_motion.sweep;
    Vec3 place{0};
    place[u] = m_motion.centre[u] + r * std::cos(angle);
    place[v] = m_motion.centre[v] + r * std::sin(angle);
    place[n] = m_motion.start[n] + t * (m_motion.end[n] - m_motion.start[n]);
    return place;
}

Vec3 oraclePoint(const Motion& motion, double t) {
    return OraclePath(motion, 0).at(t);
}

OracleHeight oracleEnvelope(const Cutter& cutter, const OraclePath& path, double x, double y) {
    return Search(cutter, path, x, y).run();
}

} // namespace proveout
