// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/samples/block_budget.h"

#include <algorithm>
#include <cassert>
#include <queue>
#include <set>
#include <tuple>

namespace proveout::samples {

namespace {

/// Pieces of all polylines lie in one queue, the worst first; ties go to the earlier one.
struct Piece {
    double deviation;
    std::size_t polyline;
    std::size_t first;
    std::size_t last;
    std::size_t worst; ///< dense point of the deviation
};

bool operator<(const Piece& a, const Piece& b) {
    return std::tuple(a.deviation, b.polyline, b.first) < std::tuple(b.deviation, a.polyline, a.first);
}

double squaredDistance(const Vec3& point, const Vec3& a, const Vec3& b) {
    const Vec3 along = b - a;
    const double length = glm::dot(along, along);
    const double t = length > 0 ? std::clamp(glm::dot(point - a, along) / length, 0.0, 1.0) : 0.0;
    const Vec3 off = point - (a + t * along);
    return glm::dot(off, off);
}

Piece measure(const std::vector<Polyline>& dense, std::size_t polyline, std::size_t first, std::size_t last) {
    const Polyline& points = dense[polyline];
    // A straight run has no deviation; the middle is then as good a place to split as any.
    Piece piece{-1.0, polyline, first, last, (first + last) / 2};
    for (std::size_t i = first + 1; i < last; ++i) {
        const double deviation = squaredDistance(points[i], points[first], points[last]);
        if (deviation > piece.deviation && deviation > 1e-12) {
            piece.deviation = deviation;
            piece.worst = i;
        }
    }
    return piece;
}

} // namespace

std::vector<Polyline> spendSegments(const std::vector<Polyline>& dense, std::size_t segments) {
    std::vector<std::set<std::size_t>> kept(dense.size());
    std::priority_queue<Piece> queue;
    for (std::size_t i = 0; i < dense.size(); ++i) {
        const std::size_t last = dense[i].size() - 1;
        std::vector<std::size_t> ends{0, last};
        if (dense[i].front() == dense[i].back())
            ends.insert(ends.begin() + 1, last / 2);
        kept[i].insert(ends.begin(), ends.end());
        for (std::size_t k = 1; k < ends.size(); ++k)
            queue.push(measure(dense, i, ends[k - 1], ends[k]));
    }
    assert(queue.size() <= segments);

    for (std::size_t count = queue.size(); count < segments; ++count) {
        const Piece piece = queue.top();
        queue.pop();
        assert(piece.last - piece.first > 1);
        kept[piece.polyline].insert(piece.worst);
        queue.push(measure(dense, piece.polyline, piece.first, piece.worst));
        queue.push(measure(dense, piece.polyline, piece.worst, piece.last));
    }

    std::vector<Polyline> coarse(dense.size());
    for (std::size_t i = 0; i < dense.size(); ++i)
        for (const std::size_t point : kept[i])
            coarse[i].push_back(dense[i][point]);
    return coarse;
}

double depthUnder(const Polyline& dense, const Polyline& coarse) {
    double depth = 0;
    std::size_t piece = 1;
    for (const Vec3& point : dense) {
        while (piece + 1 < coarse.size() && (point.x - coarse[piece].x) * (coarse[piece].x - coarse[0].x) > 0)
            ++piece;
        const Vec3& a = coarse[piece - 1];
        const Vec3& b = coarse[piece];
        const double t = (point.x - a.x) / (b.x - a.x);
        depth = std::max(depth, point.z - (a.z + t * (b.z - a.z)));
    }
    return depth;
}

} // namespace proveout::samples
