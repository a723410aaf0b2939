// SPDX-License-Identifier: GPL-3.0-or-later
// Marching squares. Each cell turns the pattern of its four corners into directed pieces from cell edge to
// cell edge; following the pieces gives the contours.
#include "resources/samples/contour.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>

namespace proveout::samples {

namespace {

/// An edge of the lattice: from point (i, j) one step along +x (axis 0) or +y (axis 1).
struct Edge {
    int j;
    int i;
    int axis;
    friend bool operator==(const Edge&, const Edge&) = default;
    friend bool operator<(const Edge& a, const Edge& b) {
        return std::tie(a.j, a.i, a.axis) < std::tie(b.j, b.i, b.axis);
    }
};

enum Side : std::uint8_t { bottom, right, top, left };

/// Pieces per corner pattern: bit 0 is the lower-left corner, then counter-clockwise; a set bit is higher
/// than the level. Higher ground lies on the right of a piece. Saddles are cut so that high corners stay
/// apart.
using Pieces = std::vector<std::pair<Side, Side>>;
const std::array<Pieces, 16>& patterns() {
    static const std::array<Pieces, 16> kPatterns{{
        {},
        {{left, bottom}},
        {{bottom, right}},
        {{left, right}},
        {{right, top}},
        {{left, bottom}, {right, top}},
        {{bottom, top}},
        {{left, top}},
        {{top, left}},
        {{top, bottom}},
        {{bottom, right}, {top, left}},
        {{top, right}},
        {{right, left}},
        {{right, bottom}},
        {{bottom, left}},
        {},
    }};
    return kPatterns;
}

Edge edgeOf(int i, int j, Side side) {
    switch (side) {
    case bottom:
        return {j, i, 0};
    case right:
        return {j, i + 1, 1};
    case top:
        return {j + 1, i, 0};
    case left:
        break;
    }
    return {j, i, 1};
}

std::map<Edge, Edge> directedPieces(const HeightMap& map, double level) {
    std::map<Edge, Edge> next;
    for (int j = 0; j + 1 < map.ny; ++j) {
        for (int i = 0; i + 1 < map.nx; ++i) {
            const unsigned pattern = (map.at(i, j) > level ? 1U : 0U) | (map.at(i + 1, j) > level ? 2U : 0U) |
                                     (map.at(i + 1, j + 1) > level ? 4U : 0U) |
                                     (map.at(i, j + 1) > level ? 8U : 0U);
            for (const auto& [from, to] : patterns()[pattern])
                next.emplace(edgeOf(i, j, from), edgeOf(i, j, to));
        }
    }
    return next;
}

Vec3 crossing(const HeightMap& map, const Edge& edge, double level) {
    const double a = map.at(edge.i, edge.j);
    const double b = edge.axis == 0 ? map.at(edge.i + 1, edge.j) : map.at(edge.i, edge.j + 1);
    const double t = (level - a) / (b - a);
    return edge.axis == 0 ? Vec3(map.x(edge.i) + t * map.step, map.y(edge.j), level)
                          : Vec3(map.x(edge.i), map.y(edge.j) + t * map.step, level);
}

} // namespace

std::vector<Polyline> contours(const HeightMap& map, double level) {
    std::map<Edge, Edge> next = directedPieces(map, level);
    std::vector<Polyline> closed;
    while (!next.empty()) {
        const Edge start = next.begin()->first;
        Polyline loop;
        Edge edge = start;
        for (auto piece = next.find(edge); piece != next.end(); piece = next.find(edge)) {
            loop.push_back(crossing(map, edge, level));
            edge = piece->second;
            next.erase(piece);
        }
        if (edge != start)
            continue;
        const auto rightmost = std::max_element(loop.begin(), loop.end(),
                                                [](const Vec3& a, const Vec3& b) { return a.x < b.x; });
        std::rotate(loop.begin(), rightmost, loop.end());
        loop.push_back(loop.front());
        closed.push_back(std::move(loop));
    }
    return closed;
}

} // namespace proveout::samples
