// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/run/motion_index.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "core/cutting/rows/arc_sweep.h"

namespace proveout {

namespace {

constexpr double kSlack = 1e-3; ///< of the spacing: a point on the rim of a cutter is cut

struct Tiles {
    int first;
    int last; ///< less than `first`: none
};

/// The part of [0, 1] in which from + t · (to - from) is in [lo, hi]; empty if its end is before its begin.
struct Part {
    double begin = 0;
    double end = 1;

    void clip(double from, double to, double lo, double hi) {
        if (from == to) {
            if (!(from >= lo && from <= hi))
                end = -1;
            return;
        }
        const double atLo = (lo - from) / (to - from);
        const double atHi = (hi - from) / (to - from);
        begin = std::max(begin, std::min(atLo, atHi));
        end = std::min(end, std::max(atLo, atHi));
    }
};

/// Where the points that a tile depends on begin and end along one axis, mm from the corner of the grid.
double beginOf(int tile, double spacing) {
    return (static_cast<double>(tile) * Tile::kSize - MotionIndex::kPointsBefore - kSlack) * spacing;
}

double endOf(int tile, double spacing) {
    return beginOf(tile, spacing) +
           (Tile::kSize - 1 + MotionIndex::kPointsBefore + MotionIndex::kPointsAfter + 2 * kSlack) * spacing;
}

/// The tiles that depend on points in [lo, hi]; computed in double, as a motion may reach farther than any
/// index.
Tiles tilesOver(double lo, double hi, double spacing, int tiles) {
    const double first = std::ceil((lo - endOf(0, spacing)) / (Tile::kSize * spacing));
    const double last = std::floor((hi - beginOf(0, spacing)) / (Tile::kSize * spacing));
    if (!(first <= last) || !(last >= 0) || !(first <= tiles - 1))
        return {0, -1};
    return {static_cast<int>(std::max(first, 0.0)), static_cast<int>(std::min(last, tiles - 1.0))};
}

int tilesAlong(int points) {
    return (points + Tile::kSize - 1) / Tile::kSize;
}

} // namespace

MotionIndex::MotionIndex(const StockBox& stock, const Grid& grid)
    : m_grid(grid), m_topZ(stock.topZ()), m_tilesX(tilesAlong(grid.nx)), m_tilesY(tilesAlong(grid.ny)),
      m_runs(static_cast<std::size_t>(m_tilesX) * static_cast<std::size_t>(m_tilesY)) {}

void MotionIndex::append(const CutterMotion& one) {
    const Motion& motion = one.motion;
    if (one.cutter != nullptr && motion.known() && withinLimits(motion)) {
        if (motion.kind == MotionKind::arc && motion.sweep != 0)
            appendArc(motion, one.cutter->radius());
        else
            appendLine(motion, one.cutter->radius());
    }
    ++m_motions;
}

/// Only the part below the top of the stock.
void MotionIndex::appendLine(const Motion& motion, double radius) {
    Part below;
    below.clip(motion.start.z, motion.end.z, -std::numeric_limits<double>::max(), m_topZ);
    if (!(below.begin <= below.end) || !(std::min(motion.start.z, motion.end.z) < m_topZ))
        return;
    const Vec2 corner(m_grid.x0, m_grid.y0);
    const Vec2 start = Vec2(motion.start) - corner;
    const Vec2 along = Vec2(motion.end - motion.start);
    append({start + along * below.begin, start + along * below.end}, radius);
}

void MotionIndex::appendArc(const Motion& motion, double radius) {
    std::vector<ArcPart> parts = splitArc(arcPath(motion, Vec3(m_grid.x0, m_grid.y0, 0)));
    std::erase_if(parts, [&](const ArcPart& part) { return !(part.lowestZ < m_topZ); });
    if (parts.empty())
        return;
    Piece all{parts.front().lo, parts.front().hi, false};
    for (const ArcPart& part : parts) {
        all.from = glm::min(all.from, part.lo);
        all.to = glm::max(all.to, part.hi);
    }
    const Vec2 size = all.to - all.from;
    if (std::max(size.x / m_grid.hx, size.y / m_grid.hy) < Tile::kSize)
        return append(all, radius); // its parts are over the same tiles
    for (const ArcPart& part : parts)
        append({part.lo, part.hi, false}, radius);
}

void MotionIndex::append(const Piece& piece, double radius) {
    const auto [lowY, highY] = std::minmax(piece.from.y, piece.to.y);
    const Tiles rows = tilesOver(lowY - radius, highY + radius, m_grid.hy, m_tilesY);
    for (int row = rows.first; row <= rows.last; ++row) {
        Part part;
        if (piece.straight)
            part.clip(piece.from.y, piece.to.y, beginOf(row, m_grid.hy) - radius,
                      endOf(row, m_grid.hy) + radius);
        if (!(part.begin <= part.end))
            continue;
        const double width = piece.to.x - piece.from.x;
        const double first = piece.from.x + part.begin * width;
        const double last = piece.from.x + part.end * width;
        const Tiles columns =
            tilesOver(std::min(first, last) - radius, std::max(first, last) + radius, m_grid.hx, m_tilesX);
        for (int column = columns.first; column <= columns.last; ++column)
            appendTo(static_cast<std::size_t>(row) * static_cast<std::size_t>(m_tilesX) +
                     static_cast<std::size_t>(column));
    }
}

void MotionIndex::appendTo(std::size_t tile) {
    std::vector<Run>& runs = m_runs[tile];
    const auto motion = static_cast<std::uint32_t>(m_motions);
    if (runs.empty() || runs.back().last < motion)
        runs.push_back({motion, motion + 1});
    else
        runs.back().last = motion + 1;
}

void MotionIndex::truncate(std::size_t motions) {
    if (motions >= m_motions)
        return;
    m_motions = motions;
    for (std::vector<Run>& runs : m_runs) {
        while (!runs.empty() && runs.back().first >= motions)
            runs.pop_back();
        if (!runs.empty())
            runs.back().last = std::min(runs.back().last, static_cast<std::uint32_t>(motions));
    }
}

std::vector<Program::MotionRange> MotionIndex::over(std::size_t tile, std::size_t motions) const {
    std::vector<Program::MotionRange> ranges;
    for (const Run& run : m_runs[tile]) {
        if (run.first >= motions)
            break;
        ranges.push_back({run.first, std::min<std::size_t>(run.last, motions)});
    }
    return ranges;
}

std::size_t MotionIndex::endOver(std::size_t tile, std::size_t motions) const {
    const std::vector<Run>& runs = m_runs[tile];
    const auto after = std::ranges::lower_bound(runs, motions, {}, &Run::first);
    return after == runs.begin() ? 0 : std::min<std::size_t>(std::prev(after)->last, motions);
}

std::size_t MotionIndex::bytes() const {
    std::size_t bytes = m_runs.capacity() * sizeof(std::vector<Run>);
    for (const std::vector<Run>& runs : m_runs)
        bytes += runs.capacity() * sizeof(Run);
    return bytes;
}

} // namespace proveout
