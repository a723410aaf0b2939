// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/cut/unseen_ribs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/cutting/cut/falling_edges.h"
#include "core/cutting/cut/sweep.h"
#include "core/cutting/profiles/vector_clones.h"

namespace proveout {

namespace {

/// Heights of one floor differ by less, mm: kernels compute in single precision.
constexpr float kSameFloor = 1e-4F;
/// Ribs are thicker, mm: passes may meet without a gap.
constexpr double kThinnest = 1e-4;
/// Of a rib over its floor, as a part of an edge: the least height of a wall.
constexpr double kLeastHeight = kWallSlope / 2;
constexpr int kHalvingsOfCover = 40;

/// The points of a tile, with one before it and one after it.
constexpr std::size_t kWide = Tile::kSize + 2;
using Heights = std::array<float, kWide * kWide>;
using RowMarks = std::array<std::uint8_t, kWide - 1>;

/// Marks the cells between two rows of heights that are level, and below the top of the stock. Returns
/// whether there is one.
PROVEOUT_VECTOR_CLONES bool markLevel(const float* row, const float* next, RowMarks& marks) {
    std::uint8_t any = 0;
    for (std::size_t i = 0; i < marks.size(); ++i) {
        const float a = std::max(row[i], row[i + 1]);
        const float b = std::max(next[i], next[i + 1]);
        const float c = std::min(row[i], row[i + 1]);
        const float d = std::min(next[i], next[i + 1]);
        const float highest = a > b ? a : b;
        const float lowest = c < d ? c : d;
        const bool isLevel = highest - lowest <= kSameFloor && highest < -kSameFloor;
        marks[i] = isLevel ? 1 : 0;
        any = static_cast<std::uint8_t>(any | marks[i]);
    }
    return any != 0;
}

struct PartOfPass {
    const FlatPass* pass;
    std::size_t part;

    [[nodiscard]] bool covers(const Vec2& place) const { return pass->covers(part, place); }
};

/// The farthest place of an edge from `from` that a part covers, as a part of the edge; it covers the place
/// at `begin`.
double endOfCover(const PartOfPass& part, const Vec2& from, const Vec2& way, double begin) {
    if (part.covers(from + way))
        return 1;
    double inside = begin;
    double outside = 1;
    for (int k = 0; k < kHalvingsOfCover; ++k) {
        const double middle = (inside + outside) / 2;
        (part.covers(from + way * middle) ? inside : outside) = middle;
    }
    return inside;
}

/// How far several parts cover an edge from its first point without a gap, as a part of it.
double coverFrom(const std::vector<PartOfPass>& parts, const Vec2& from, const Vec2& way, double gap) {
    double end = 0;
    for (bool goesOn = true; goesOn && end < 1;) {
        goesOn = false;
        const double begin = end == 0 ? 0 : std::min(end + gap, 1.0);
        for (const PartOfPass& part : parts) {
            if (!part.covers(from + way * begin))
                continue;
            const double to = endOfCover(part, from, way, begin);
            goesOn = goesOn || to > end + gap;
            end = std::max(end, to);
        }
    }
    return end;
}

} // namespace

UnseenRibs::UnseenRibs(const ZMapSnapshot& zmap, std::size_t tile)
    : m_zmap(zmap), m_tile(zmap.tileRect(tile)), m_topZ(zmap.stock().topZ()) {
    const Grid& grid = zmap.grid();
    const IndexRect known =
        intersection({m_tile.i0 - 1, m_tile.j0 - 1, m_tile.i1 + 1, m_tile.j1 + 1}, {0, 0, grid.nx, grid.ny});
    Heights read;
    zmap.read(known, read);
    const auto width = static_cast<std::size_t>(known.width());
    const auto beforeX = static_cast<std::size_t>(known.i0 - (m_tile.i0 - 1));
    const auto beforeY = static_cast<std::size_t>(known.j0 - (m_tile.j0 - 1));
    Heights heights{}; // outside the map as high as the top, where no floor is
    for (std::size_t j = 0; j < static_cast<std::size_t>(known.height()); ++j)
        std::copy_n(read.data() + j * width, width, heights.data() + (j + beforeY) * kWide + beforeX);
    RowMarks marks;
    for (std::size_t j = 0; j + 1 < kWide; ++j) {
        const float* row = heights.data() + j * kWide;
        if (!markLevel(row, row + kWide, marks))
            continue;
        for (std::size_t i = 0; i < marks.size(); ++i)
            if (marks[i] != 0)
                addCell(static_cast<int>(i) - 1, static_cast<int>(j) - 1, double{row[i]});
    }
}

void UnseenRibs::addCell(int i, int j, double height) {
    std::optional<std::size_t> known = floorAt(height);
    if (!known) {
        known = m_floors.size();
        m_floors.emplace_back().height = height;
    }
    Floor& floor = m_floors[*known];
    const auto set = [](Rows& edges, int x, int y) {
        if (x >= 0 && y >= 0)
            edges[static_cast<std::size_t>(y)].set(static_cast<std::size_t>(x));
    };
    set(floor.alongX, i, j);
    set(floor.alongX, i, j + 1);
    set(floor.alongY, i, j);
    set(floor.alongY, i + 1, j);
}

std::optional<std::size_t> UnseenRibs::floorAt(double height) const {
    const double cut = std::max(height, static_cast<double>(m_zmap.floor()));
    for (std::size_t k = 0; k < m_floors.size(); ++k)
        if (std::abs(m_floors[k].height - cut) <= 2 * double{kSameFloor})
            return k;
    return std::nullopt;
}

Vec2 UnseenRibs::placeOf(int i, int j) const {
    return {m_zmap.grid().x(m_tile.i0 + i), m_zmap.grid().y(m_tile.j0 + j)};
}

void UnseenRibs::add(const CutterMotion& motion) {
    if (motion.cutter == nullptr)
        return;
    if (std::exchange(m_cutter, motion.cutter) != motion.cutter)
        m_end.emplace(*motion.cutter);
    if (!mayBeOnFloor(motion.motion))
        return;
    std::optional<FlatPass> pass = FlatPass::of(*m_end, motion.motion, m_topZ);
    if (!pass)
        return;
    if (const auto at = floorAt(pass->height())) {
        cover(m_floors[*at], *pass);
        m_floors[*at].passes.push_back(std::move(*pass));
    }
}

bool UnseenRibs::mayBeOnFloor(const Motion& motion) const {
    const bool isArc = motion.kind == MotionKind::arc;
    const double lowest = std::min(motion.start.z, motion.end.z) + m_end->height - m_topZ;
    if (!(m_end->radius > 0) || (isArc && motion.start.z != motion.end.z) || !floorAt(lowest))
        return false;
    const Vec2 around(m_end->radius + (isArc ? 2 * glm::distance(motion.start, motion.centre) : 0));
    const PlanArea near{glm::min(Vec2(motion.start), Vec2(motion.end)) - around,
                        glm::max(Vec2(motion.start), Vec2(motion.end)) + around};
    return near.meets(PlanArea{placeOf(0, 0), placeOf(kSide, kSide)});
}

void UnseenRibs::cover(Floor& floor, const FlatPass& pass) const {
    const Grid& grid = m_zmap.grid();
    const PlanArea tile{placeOf(0, 0), placeOf(kSide - 1, kSide - 1)};
    const auto rowAt = [&](double y) {
        return static_cast<std::size_t>(std::clamp((y - tile.lo.y) / grid.hy, 0.0, double{kSide}));
    };
    struct Part {
        std::size_t begin = 0; // its rows
        std::size_t end = 0;
        std::array<Row, kSide + 1> points; // others are empty
    };
    Part before;
    Part now;
    for (std::size_t part = 0; part < pass.parts(); ++part) {
        std::fill(now.points.begin() + now.begin, now.points.begin() + now.end, Row{});
        now.begin = now.end = 0;
        if (const PlanArea area = pass.areaOf(part); area.meets(tile)) {
            now.begin = rowAt(area.lo.y);
            now.end = std::min<std::size_t>(rowAt(area.hi.y) + 1, kSide);
        }
        for (std::size_t j = now.begin; j < now.end; ++j)
            now.points[j] =
                pass.pointsUnder(part, {tile.lo.x, grid.hx, tile.lo.y + grid.hy * static_cast<double>(j),
                                        static_cast<int>(kSide)});
        if (now.begin == now.end) {
            std::swap(before, now);
            continue;
        }
        const std::size_t end = std::max(before.end, now.end);
        for (std::size_t j = before.begin == before.end ? now.begin : std::min(before.begin, now.begin);
             j < end; ++j) {
            const Row both = before.points[j] | now.points[j];
            floor.coveredX[j] |= both & (both >> 1);
            floor.coveredY[j] |= both & (before.points[j + 1] | now.points[j + 1]);
        }
        std::swap(before, now);
    }
}

bool UnseenRibs::suspects(const StockTop* uncut) {
    for (const Floor& floor : m_floors) {
        for (int j = 0; j < Tile::kSize; ++j) {
            const auto row = static_cast<std::size_t>(j);
            const Row alongX = floor.alongX[row] & ~floor.coveredX[row];
            const Row alongY = floor.alongY[row] & ~floor.coveredY[row];
            if (alongX.none() && alongY.none())
                continue;
            for (int i = 0; i < Tile::kSize; ++i) {
                if (alongX.test(static_cast<std::size_t>(i)))
                    suspect(floor, {i, j, false}, uncut);
                if (alongY.test(static_cast<std::size_t>(i)))
                    suspect(floor, {i, j, true}, uncut);
            }
        }
    }
    return !m_suspects.empty();
}

void UnseenRibs::suspect(const Floor& floor, const RimEdge& edge, const StockTop* uncut) {
    const Vec2 from = placeOf(edge.i, edge.j);
    const Vec2 to = placeOf(edge.i + (edge.alongY ? 0 : 1), edge.j + (edge.alongY ? 1 : 0));
    std::vector<PartOfPass> parts;
    for (const FlatPass& pass : floor.passes)
        for (std::size_t part = 0; part < pass.parts(); ++part)
            if (pass.areaOf(part).meets(PlanArea{from, to}))
                parts.push_back({&pass, part});
    const double gap = kThinnest / glm::distance(from, to);
    const double end = coverFrom(parts, from, to - from, gap);
    const double begin = 1 - coverFrom(parts, to, from - to, gap);
    if (!(begin - end > gap))
        return;
    for (const double part : {0.1, 0.3, 0.5, 0.7, 0.9}) { // others may pass between
        const Vec2 place = from + (to - from) * glm::mix(end, begin, part);
        const double top = uncut == nullptr ? 0 : std::min(0.0, uncut->height(place));
        m_suspects.push_back({edge, floor.height, place, top});
    }
}

void UnseenRibs::lower(const CutterMotion& motion) {
    if (motion.cutter == nullptr)
        return;
    const Sweep sweep(*motion.cutter, motion.motion, m_topZ);
    if (sweep.empty())
        return;
    for (Suspect& at : m_suspects) {
        const Box3& reach = sweep.reach();
        if (reach.lo.x <= at.place.x && reach.hi.x >= at.place.x && reach.lo.y <= at.place.y &&
            reach.hi.y >= at.place.y && reach.lo.z < at.height)
            at.height = std::min(at.height, sweep.envelope(at.place.x, at.place.y, at.height));
    }
}

std::vector<std::uint16_t> UnseenRibs::edges() const {
    std::vector<std::uint16_t> edges;
    for (const Suspect& at : m_suspects) {
        const double length = at.edge.alongY ? m_zmap.grid().hy : m_zmap.grid().hx;
        if (at.height - at.floor > kLeastHeight * length)
            edges.push_back(at.edge.index());
    }
    std::ranges::sort(edges);
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end()); // clang 14 lacks that of ranges
    return edges;
}

} // namespace proveout
