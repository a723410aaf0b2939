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
/// Between places of an edge at which a rib of the stock, which may be anywhere on it, is looked for.
constexpr int kStepsOfEdge = 32;

/// The points of a tile, with one before it and two after it: all cells at its points and the next ones.
constexpr std::size_t kWide = Tile::kSize + 3;
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

} // namespace

UnseenRibs::UnseenRibs(const ZMapSnapshot& zmap, std::size_t tile, const RimTile* ofStock)
    : m_zmap(zmap), m_tile(zmap.tileRect(tile)), m_ofStock(ofStock), m_topZ(zmap.stock().topZ()) {
    if (ofStock != nullptr)
        for (const std::uint16_t edge : ofStock->unseenRibs)
            addRibOfStock(RimEdge::of(edge));
    const Grid& grid = zmap.grid();
    const IndexRect known =
        intersection({m_tile.i0 - 1, m_tile.j0 - 1, m_tile.i1 + 2, m_tile.j1 + 2}, {0, 0, grid.nx, grid.ny});
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

void UnseenRibs::addRibOfStock(const RimEdge& edge) {
    const int i = m_tile.i0 + edge.i;
    const int j = m_tile.j0 + edge.j;
    const float floor =
        std::max(m_zmap.height(i, j), m_zmap.height(i + (edge.alongY ? 0 : 1), j + (edge.alongY ? 1 : 0)));
    const Vec2 from = placeOf(edge.i, edge.j);
    for (int step = 0; step <= kStepsOfEdge; ++step) {
        const Vec2 place = glm::mix(from, endOf(edge), static_cast<double>(step) / kStepsOfEdge);
        m_suspects[squareOf(edge)].push_back({edge, double{floor}, place, 0}); // how high it is is unknown
        ++m_count;
    }
}

void UnseenRibs::addCell(int i, int j, double height) {
    std::optional<std::size_t> known = floorAt(height);
    if (!known) {
        known = m_floors.size();
        m_floors.emplace_back().height = height;
    }
    Floor& floor = m_floors[*known];
    for (const auto& [x, y] : {std::pair(i, j), {i + 1, j}, {i, j + 1}, {i + 1, j + 1}})
        if (x >= 0 && y >= 0 && x < kSide && y < kSide)
            floor.points[static_cast<std::size_t>(y)].set(static_cast<std::size_t>(x));
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

Vec2 UnseenRibs::endOf(const RimEdge& edge) const {
    return placeOf(edge.i + (edge.alongY ? 0 : 1), edge.j + (edge.alongY ? 1 : 0));
}

void UnseenRibs::add(const CutterMotion& motion) {
    if (motion.cutter == nullptr)
        return;
    if (std::exchange(m_cutter, motion.cutter) != motion.cutter)
        m_end.emplace(*motion.cutter);
    if (!mayBeOnFloor(motion.motion))
        return;
    const std::optional<FlatPass> pass =
        FlatPass::of(*m_end, motion.motion, m_topZ, static_cast<double>(m_zmap.floor()));
    const auto at = pass ? floorAt(pass->height()) : std::nullopt;
    if (!at)
        return;
    Floor& floor = m_floors[*at];
    const double edge = std::max(m_zmap.grid().hx, m_zmap.grid().hy);
    if (!pass->mayLeavePillar(edge))
        cover(floor, *pass);
    for (std::size_t part = 0; part < pass->parts(); ++part)
        eachSquare(pass->areaOf(part), [&](std::size_t square) {
            floor.parts[square].push_back(
                {static_cast<std::uint32_t>(floor.passes.size()), static_cast<std::uint32_t>(part)});
        });
    floor.passes.push_back(*pass);
}

template<class Visit>
void UnseenRibs::eachSquare(const PlanArea& area, const Visit& visit) const {
    const Vec2 first = placeOf(0, 0);
    const Vec2 size = Vec2(m_zmap.grid().hx, m_zmap.grid().hy) * double{kPoints};
    // The edges of a square reach to the first points of the next one.
    const auto squares = [](double low, double high) {
        constexpr double kNear = 1e-3;
        return std::pair(
            std::max(static_cast<int>(std::floor(std::clamp(low - kNear, -1.0, 9.0))), 0),
            std::min(static_cast<int>(std::floor(std::clamp(high + kNear, -1.0, 9.0))), kSquares - 1));
    };
    const auto [i0, i1] = squares((area.lo.x - first.x) / size.x, (area.hi.x - first.x) / size.x);
    const auto [j0, j1] = squares((area.lo.y - first.y) / size.y, (area.hi.y - first.y) / size.y);
    for (int j = j0; j <= j1; ++j)
        for (int i = i0; i <= i1; ++i)
            visit(static_cast<std::size_t>(j * kSquares + i));
}

bool UnseenRibs::mayBeOnFloor(const Motion& motion) const {
    const bool isArc = motion.kind == MotionKind::arc;
    const double lowest = std::min(motion.start.z, motion.end.z) + m_end->lowest() - m_topZ;
    if ((isArc && motion.start.z != motion.end.z) || !floorAt(lowest))
        return false;
    const Vec2 around(m_cutter->radius() + (isArc ? 2 * glm::distance(motion.start, motion.centre) : 0));
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
    for (int j = 0; j < Tile::kSize; ++j) {
        suspectRow(j, false, uncut);
        suspectRow(j, true, uncut);
    }
    return m_count > 0;
}

void UnseenRibs::suspectRow(int j, bool alongY, const StockTop* uncut) {
    const auto row = static_cast<std::size_t>(j);
    const auto edgesOf = [&](const Row& points, const Row& next) {
        return points & (alongY ? next : points >> 1);
    };
    Row points; // of any floor
    Row next;
    Row level; // edges on one floor
    Row wanted;
    for (const Floor& floor : m_floors) {
        const Row edges = edgesOf(floor.points[row], floor.points[row + 1]);
        wanted |= edges & ~(alongY ? floor.coveredY : floor.coveredX)[row];
        level |= edges;
        points |= floor.points[row];
        next |= floor.points[row + 1];
    }
    wanted |= edgesOf(points, next) & ~level;
    if (wanted.none())
        return;
    for (int i = 0; i < Tile::kSize; ++i) {
        if (!wanted.test(static_cast<std::size_t>(i)))
            continue;
        const Floor* first = floorOf(i, j);
        const Floor* second = floorOf(i + (alongY ? 0 : 1), j + (alongY ? 1 : 0));
        if (first == nullptr || second == nullptr)
            continue;
        const Floor& higher = first->height < second->height ? *second : *first;
        if (!(alongY ? higher.coveredY : higher.coveredX)[row].test(static_cast<std::size_t>(i)))
            suspect(higher, {i, j, alongY}, uncut);
    }
}

const UnseenRibs::Floor* UnseenRibs::floorOf(int i, int j) const {
    const Floor* highest = nullptr;
    for (const Floor& floor : m_floors)
        if (floor.points[static_cast<std::size_t>(j)].test(static_cast<std::size_t>(i)) &&
            (highest == nullptr || floor.height > highest->height))
            highest = &floor;
    return highest;
}

void UnseenRibs::suspect(const Floor& floor, const RimEdge& edge, const StockTop* uncut) {
    const Vec2 from = placeOf(edge.i, edge.j);
    const Vec2 to = endOf(edge);
    const double length = glm::distance(from, to);
    const std::size_t square = squareOf(edge);
    const bool hadRib =
        m_ofStock != nullptr && std::ranges::binary_search(m_ofStock->unseenRibs, edge.index());
    std::vector<Span> covered;
    for (const Floor& below : m_floors) {
        if (below.height > floor.height)
            continue;
        for (const auto& [pass, part] : below.parts[square]) {
            if (!below.passes[pass].areaOf(part).meets(PlanArea{from, to}))
                continue;
            const Span span = below.passes[pass].spanOn(part, from, edge.alongY);
            if (span.lo <= span.hi && span.hi >= 0 && span.lo <= length)
                covered.push_back(span);
        }
    }
    std::ranges::sort(covered, {}, &Span::lo);
    if (covered.empty() || covered.front().lo > kThinnest ||
        std::ranges::max(covered, {}, &Span::hi).hi < length - kThinnest)
        return; // an end is on a floor of the stock, or on one that something else has cut
    double end = covered.front().hi;
    for (const Span& span : covered) {
        if (span.lo - end > kThinnest) {
            const Vec2 place = from + (to - from) * ((end + span.lo) / 2 / length);
            const double top = uncut == nullptr || hadRib ? 0 : std::min(0.0, uncut->height(place));
            m_suspects[square].push_back({edge, floor.height, place, top});
            ++m_count;
        }
        end = std::max(end, span.hi);
    }
}

void UnseenRibs::lower(const CutterMotion& motion) {
    if (motion.cutter == nullptr)
        return;
    const Sweep sweep(*motion.cutter, motion.motion, m_topZ);
    if (sweep.empty())
        return;
    const Box3& reach = sweep.reach();
    eachSquare({Vec2(reach.lo), Vec2(reach.hi)}, [&](std::size_t square) {
        for (Suspect& at : m_suspects[square])
            if (reach.lo.z < at.height)
                at.height = std::min(at.height, sweep.envelope(at.place.x, at.place.y, at.height));
    });
}

std::vector<std::uint16_t> UnseenRibs::edges() const {
    std::vector<std::uint16_t> edges;
    for (const std::vector<Suspect>& ofSquare : m_suspects) {
        for (const Suspect& at : ofSquare) {
            const double length = at.edge.alongY ? m_zmap.grid().hy : m_zmap.grid().hx;
            if (at.height - at.floor > kLeastHeight * length)
                edges.push_back(at.edge.index());
        }
    }
    std::ranges::sort(edges);
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end()); // clang 14 lacks that of ranges
    return edges;
}

} // namespace proveout
