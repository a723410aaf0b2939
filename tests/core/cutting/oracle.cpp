// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/cutting/oracle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace proveout {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kRimMask = 2e-5; // where a micrometre over ground is many of height

/// The profile by its shape's own formula would be more independent still; Cutter::height is checked against
/// those in cutter_test.
double heightOver(const Cutter& cutter, double distance) {
    return distance <= cutter.radius() ? cutter.height(distance) : kInfinity;
}

/// Golden section on a triple a < m < b with f(m) no higher than both; what is infinite counts as high.
double refine(const std::function<double(double)>& f, double a, double m, double b) {
    constexpr double kGolden = 0.381966011250105;
    double best = f(m);
    for (int step = 0; step < 90 && b - a > 1e-15; ++step) {
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

/// The radii at which the profile stands upright.
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

/// The places between two neighbours at which the path comes under another piece of the profile, each on the
/// side that is nearer.
void addCrossings(const Cutter& cutter, const std::function<double(double)>& distance,
                  std::vector<double>& places) {
    std::vector<double> crossings;
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
        const double first = distance(places[k]);
        const double second = distance(places[k + 1]);
        for (const ProfilePiece& piece : cutter.pieces()) {
            if ((first <= piece.r1) == (second <= piece.r1))
                continue;
            double inside = first <= piece.r1 ? places[k] : places[k + 1];
            double outside = first <= piece.r1 ? places[k + 1] : places[k];
            for (int step = 0; step < 60; ++step) {
                const double middle = (inside + outside) / 2;
                (distance(middle) <= piece.r1 ? inside : outside) = middle;
            }
            crossings.push_back(inside);
        }
    }
    places.insert(places.end(), crossings.begin(), crossings.end());
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
}

} // namespace

Vec3 oraclePoint(const Motion& motion, double t) {
    if (motion.kind != MotionKind::arc)
        return motion.start + t * (motion.end - motion.start);
    static constexpr std::array<std::array<int, 3>, 3> kAxes = {{{0, 1, 2}, {2, 0, 1}, {1, 2, 0}}};
    const auto [u, v, n] = kAxes[static_cast<std::size_t>(motion.plane)];
    const double u0 = motion.start[u] - motion.centre[u];
    const double v0 = motion.start[v] - motion.centre[v];
    const double r0 = std::hypot(u0, v0);
    const double r1 = std::hypot(motion.end[u] - motion.centre[u], motion.end[v] - motion.centre[v]);
    const double r = r0 + t * (r1 - r0);
    const double angle = std::atan2(v0, u0) + t * motion.sweep;
    Vec3 place{0};
    place[u] = motion.centre[u] + r * std::cos(angle);
    place[v] = motion.centre[v] + r * std::sin(angle);
    place[n] = motion.start[n] + t * (motion.end[n] - motion.start[n]);
    return place;
}

OracleHeight oracleEnvelope(const Cutter& cutter, const Motion& motion, double x, double y, int samples) {
    const auto distance = [&](double t) {
        const Vec3 tip = oraclePoint(motion, t);
        return std::hypot(tip.x - x, tip.y - y);
    };
    const auto height = [&](double t) { return oraclePoint(motion, t).z + heightOver(cutter, distance(t)); };

    std::vector<double> places;
    for (int k = 0; k <= samples; ++k)
        places.push_back(static_cast<double>(k) / samples);
    std::vector<double> distances;
    for (const double t : places)
        distances.push_back(distance(t));
    const std::vector<double> walls = wallsOf(cutter);
    bool onRim = false;
    std::vector<double> nearest;
    for (std::size_t k = 0; k < places.size(); ++k) {
        const bool left = k == 0 || distances[k] <= distances[k - 1];
        const bool right = k + 1 == places.size() || distances[k] <= distances[k + 1];
        if (!left || !right)
            continue;
        double t = places[k];
        if (k > 0 && k + 1 < places.size())
            t = refine(distance, places[k - 1], t, places[k + 1]);
        else if (distances.size() > 1) // a minimum may hide beside an end
            t = refine(distance, k == 0 ? 0 : places[k - 1], k == 0 ? places[1] / 2 : (1 + places[k - 1]) / 2,
                       k == 0 ? places[1] : 1);
        nearest.push_back(t);
        for (const double wall : walls)
            onRim =
                onRim || std::abs(distance(t) - wall) < kRimMask || std::abs(distances[k] - wall) < kRimMask;
    }
    places.insert(places.end(), nearest.begin(), nearest.end());
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    addCrossings(cutter, distance, places);

    std::vector<double> heights;
    for (const double t : places)
        heights.push_back(height(t));
    double best = kInfinity;
    for (std::size_t k = 0; k < places.size(); ++k) {
        if (heights[k] == kInfinity)
            continue;
        best = std::min(best, heights[k]);
        if ((k > 0 && heights[k - 1] < heights[k]) || (k + 1 < places.size() && heights[k + 1] < heights[k]))
            continue;
        const double a = k > 0 ? places[k - 1] : places[k];
        const double b = k + 1 < places.size() ? places[k + 1] : places[k];
        best = std::min(best, height(refine(height, a, places[k], b)));
    }
    return {best, onRim};
}

} // namespace proveout
