// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/part/deviation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/parallel.h"

namespace proveout {

namespace {

/// Progress of the steps.
constexpr double kPrepared = 0.2;
constexpr double kPointsDone = 0.8;
/// More samples of steep faces are not taken.
constexpr double kMostSamples = 500'000;
/// The part of a normal along Z: faces that are steeper are sampled on their own.
constexpr double kSteepNormal = 0.5;
/// The distance along Z may be so much longer than by the slope.
constexpr double kAlongSlope = 1.1;
/// Faces are upright down to here, some 1°; below they face downwards.
constexpr double kUprightNormal = -0.02;
/// Heights of the map are exact to 1 µm, and in single precision as are those of the part.
constexpr double kSameHeight = 2e-6; // mm
/// Where a step of the grid has no rim, its wall is somewhere in a cell.
constexpr double kUncertainCells = 0.75;
/// Of a cell: a place so near to the border is on it.
constexpr double kOnBorder = 1e-3;
/// Facets that are not as wide may lie between the points.
constexpr double kNarrowCells = 2;
/// How exact swept volumes are.
constexpr double kExact = 2e-3; // mm

/// A bound that rounding does not make too small.
double atMost(double distance) {
    return distance * (1 + 1e-9) + 1e-6;
}

} // namespace

/// Decides which candidates are out of tolerance: beyond the tolerance, normal to the part, there must be air
/// where material is missing, or material where some is left.
class Deviation::Judge {
public:
    Judge(const DesignPart& part, const PartTolerance& tolerance, const IsMaterial& isMaterial)
        : m_part(part), m_tolerance(tolerance), m_isMaterial(isMaterial) {}

    enum class Verdict : std::uint8_t { in, out, unknown };
    [[nodiscard]] std::vector<Verdict> verdicts(std::span<const Candidate> candidates) const {
        std::vector<Verdict> verdicts(candidates.size(), Verdict::in);
        if (!m_isMaterial) {
            std::ranges::transform(candidates, verdicts.begin(),
                                   [this](const Candidate& candidate) { return byMap(candidate); });
            return verdicts;
        }
        std::vector<std::optional<Vec3>> places(candidates.size());
        inParallelRanges(candidates.size(), kCandidatesOfTask, [&](std::size_t first, std::size_t last) {
            for (std::size_t k = first; k < last; ++k)
                places[k] = placeBeyond(candidates[k]);
        });
        std::vector<Vec3> asked;
        for (const auto& place : places)
            if (place)
                asked.push_back(*place);
        const std::vector<bool> isMaterial = m_isMaterial(asked);
        std::size_t next = 0;
        for (std::size_t k = 0; k < candidates.size(); ++k)
            if (places[k] && isMaterial[next++] == (candidates[k].off > 0))
                verdicts[k] = Verdict::out;
        return verdicts;
    }

private:
    static constexpr std::size_t kCandidatesOfTask = 256;
    static constexpr double kFarOut = 3; ///< tolerances

    [[nodiscard]] double limit(const Candidate& candidate) const {
        return candidate.off > 0 ? m_tolerance.above : -m_tolerance.below;
    }
    [[nodiscard]] Verdict byMap(const Candidate& candidate) const {
        const double beyond = std::abs(candidate.off) - std::abs(limit(candidate));
        if (beyond > candidate.uncertain)
            return Verdict::out;
        return beyond > -candidate.uncertain && candidate.uncertain > 0 ? Verdict::unknown : Verdict::in;
    }
    /// Just beyond the tolerance. At edges of the part and in gaps, where that is nearer to another face,
    /// only what is far out of tolerance counts: neighbouring places tell the rest. Nothing: it does not
    /// count, or the place would be on the other side of the part's surface.
    [[nodiscard]] std::optional<Vec3> placeBeyond(const Candidate& candidate) const {
        const double wanted = m_tolerance.allowance + limit(candidate);
        const double side = candidate.off > 0 ? 1 : -1;
        const Vec3 place = candidate.place + candidate.normal * (wanted + side * kExact);
        const auto there = m_part.distance().at(place);
        if (!there->hasSide)
            return std::nullopt;
        if (side * there->distance >= side * wanted - kSameHeight)
            return place;
        const bool isFar = std::abs(candidate.off + m_tolerance.allowance) >
                           kFarOut * std::abs(wanted) + candidate.uncertain;
        return isFar && side * there->distance > kExact ? std::optional(place) : std::nullopt;
    }

    const DesignPart& m_part;
    const PartTolerance& m_tolerance;
    const IsMaterial& m_isMaterial;
};

/// At the points of the grid.
class Deviation::Points {
public:
    Points(const MapDistance& map, const DesignPart& part, const PartTop& top, const PartTolerance& tolerance)
        : m_map(map), m_part(part), m_top(top), m_tolerance(tolerance) {}

    struct Found {
        double value = 0;
        bool isOnPart = false;
        bool isJudged = false;
        bool hasSide = true;
        bool isPlain = false; ///< that of a slope, which is not much less in the other direction
        double ofStock = 0;   ///< the value of the stock's point alone
        bool isExact = true;  ///< as MapDistance::Nearest
    };
    /// That of the face of the part, where it can be reached from above.
    [[nodiscard]] Vec3 normalAt(const Vec3& place) const {
        const std::array<Vec3, 3> at = m_part.corners(m_part.distance().at(place)->facet);
        const Vec3 normal = glm::normalize(glm::cross(at[1] - at[0], at[2] - at[0]));
        return normal.z < kSteepNormal ? Vec3(0, 0, 1) : normal;
    }

    [[nodiscard]] Found at(int i, int j) const {
        const double top = double{m_top.at(i, j)};
        if (top == double{PartTop::kNone})
            return {};
        const ZMapSnapshot& zmap = m_map.zmap();
        const double left = double{zmap.height(i, j)} - top; // stock over the part
        Found found = fromStock(i, j, left);
        const bool isUncutTop = static_cast<double>(zmap.height(i, j)) >= -kSameHeight;
        if (isUncutTop && found.value < m_tolerance.allowance && found.value >= -m_tolerance.below) {
            found.value = m_tolerance.allowance; // the stock has no allowance on its own top
            return found;
        }
        const bool isWithin = isAllowed(left) && isAllowed(found.value);
        if (isWithin || (found.isPlain && !isAllowed(found.value)))
            return found;
        // The other direction: this place of the part may be farther from the stock.
        const Grid& grid = zmap.grid();
        const Vec3 place(grid.x(i), grid.y(j), zmap.stock().topZ() + top);
        const auto nearest = m_map.nearest(place, atMost(std::abs(left)));
        const double away = nearest ? nearest->distance : std::abs(left);
        if (away > std::abs(found.value))
            found = {std::copysign(away, left),   true, true, true, false, found.value,
                     !nearest || nearest->isExact};
        return found;
    }

private:
    [[nodiscard]] bool isAllowed(double value) const {
        const double off = value - m_tolerance.allowance;
        return off <= m_tolerance.above && off >= -m_tolerance.below;
    }

    /// The normal distance of the stock's point.
    [[nodiscard]] Found fromStock(int i, int j, double left) const {
        const ZMapSnapshot& zmap = m_map.zmap();
        const Grid& grid = zmap.grid();
        const Vec3 point(grid.x(i), grid.y(j), zmap.stock().topZ() + double{zmap.height(i, j)});
        const auto place = m_part.distance().at(point, atMost(std::abs(left)));
        if (!place)
            return {left, false, true, true, false, left, true};
        Found found{place->distance, false, true, true, isOfSlope(*place, left), place->distance, true};
        const bool isSame = std::abs(place->distance) <= kSameHeight;
        // Over the highest place of the part no point is within it. Below, a point outside is beneath an
        // overhang that is gone, or on a wall: the other direction tells.
        const bool contradicts = left > kSameHeight && place->distance < -kSameHeight;
        if (!isSame && (!place->hasSide || contradicts))
            return {std::copysign(std::abs(place->distance), left), false, true, false, false, 0, true};
        if (left < -kSameHeight && place->distance > 0)
            found.value = 0;
        return found;
    }

    /// Whether the nearest place is on a face upwards, and no nearer than its slope makes it.
    [[nodiscard]] bool isOfSlope(const PartDistance::Place& place, double left) const {
        const std::array<Vec3, 3> at = m_part.corners(place.facet);
        const Vec3 normal = glm::cross(at[1] - at[0], at[2] - at[0]);
        return normal.z >= kSteepNormal * glm::length(normal) &&
               std::abs(left) * kSteepNormal <= kAlongSlope * std::abs(place.distance);
    }

    const MapDistance& m_map;
    const DesignPart& m_part;
    const PartTop& m_top;
    const PartTolerance& m_tolerance;
};

/// At samples of steep faces.
class Deviation::Walls {
public:
    Walls(const MapDistance& map, const DesignPart& part, const PartTolerance& tolerance)
        : m_map(map), m_part(part), m_tolerance(tolerance) {
        double area = 0;
        for (std::size_t facet = 0; facet < part.mesh().triangles.size(); ++facet)
            if (const double own = areaOf(facet); own > 0) {
                m_facets.push_back(static_cast<std::uint32_t>(facet));
                area += own;
            }
        const Grid& grid = map.zmap().grid();
        m_spacing = std::max(std::min(grid.hx, grid.hy), std::sqrt(area / kMostSamples));
    }

    /// What may be out of tolerance.
    struct OfFacets {
        std::vector<WallDeviation> walls;
        std::vector<Candidate> candidates; ///< the same places
        double hiddenMm2 = 0;
    };
    void look(std::size_t first, std::size_t last, OfFacets& out) const {
        for (std::size_t k = first; k < last; ++k)
            eachSample(m_facets[k],
                       [&](const Vec3& place, double areaMm2) { lookAt(m_facets[k], place, areaMm2, out); });
    }
    [[nodiscard]] std::size_t facets() const { return m_facets.size(); }
    [[nodiscard]] double spacing() const { return m_facets.empty() ? 0 : m_spacing; }

private:
    [[nodiscard]] Vec3 normalOf(std::size_t facet) const {
        const std::array<Vec3, 3> at = m_part.corners(facet);
        return glm::cross(at[1] - at[0], at[2] - at[0]) / 2.0;
    }
    /// 0 if it faces downwards, or is neither steep nor so narrow that points of the grid may miss it.
    [[nodiscard]] double areaOf(std::size_t facet) const {
        const Vec3 normal = normalOf(facet);
        const double area = glm::length(normal);
        if (area == 0 || normal.z < kUprightNormal * area)
            return 0;
        const std::array<Vec3, 3> at = m_part.corners(facet);
        const double longest =
            std::max({glm::distance(at[0], at[1]), glm::distance(at[1], at[2]), glm::distance(at[2], at[0])});
        const Grid& grid = m_map.zmap().grid();
        const bool isNarrow = 2 * area / longest < kNarrowCells * std::max(grid.hx, grid.hy);
        return normal.z < kSteepNormal * area || isNarrow ? area : 0;
    }

    /// In rows along the longest side.
    template<class Visit>
    void eachSample(std::size_t facet, const Visit& visit) const {
        std::array<Vec3, 3> at = m_part.corners(facet);
        const auto side = [&](std::size_t k) { return glm::distance(at[k], at[(k + 1) % 3]); };
        const std::size_t longest = side(0) >= side(1) && side(0) >= side(2) ? 0 : side(1) >= side(2) ? 1 : 2;
        std::rotate(at.begin(), at.begin() + static_cast<std::ptrdiff_t>(longest), at.end());
        const double area = glm::length(normalOf(facet));
        const double length = side(0);
        const auto steps = [this](double size) {
            return std::max(1, static_cast<int>(std::ceil(size / m_spacing)));
        };
        const int rows = steps(2 * area / length);
        // With the edges: what is left along one is often thinner than the rows are apart.
        for (int row = 0; row <= rows; ++row) {
            const double part = static_cast<double>(row) / rows;
            const double begin = std::max(part - 0.5 / rows, 0.0);
            const double end = std::min(part + 0.5 / rows, 1.0);
            const int samples = steps(length * (1 - part));
            const double areaOfRow = area * ((1 - begin) * (1 - begin) - (1 - end) * (1 - end));
            const Vec3 first = glm::mix(at[0], at[2], part);
            const Vec3 last = glm::mix(at[1], at[2], part);
            for (int k = 0; k <= samples; ++k)
                visit(glm::mix(first, last, static_cast<double>(k) / samples),
                      areaOfRow / samples * (k == 0 || k == samples ? 0.5 : 1));
        }
    }

    void lookAt(std::size_t facet, const Vec3& place, double areaMm2, OfFacets& out) const {
        const ZMapSnapshot& zmap = m_map.zmap();
        const Grid& grid = zmap.grid();
        const double x = (place.x - grid.x0) / grid.hx;
        const double y = (place.y - grid.y0) / grid.hy;
        if (x < 0 || y < 0 || x > grid.nx - 1 || y > grid.ny - 1 || place.z < zmap.stock().floorZ() - kExact)
            return; // beside the stock, or below it: told as such
        if (isSeenAlong(facet, place, x, y))
            return;
        const auto nearest = m_map.nearest(place, std::numeric_limits<double>::infinity());
        if (!nearest)
            return;
        const double value = nearest->isInside ? nearest->distance : -nearest->distance;
        const double off = value - m_tolerance.allowance;
        const double uncertain = nearest->isExact ? 0 : kUncertainCells * std::max(grid.hx, grid.hy);
        if (off + uncertain <= m_tolerance.above && off - uncertain >= -m_tolerance.below)
            return;
        const bool isOnBorder =
            x < kOnBorder || y < kOnBorder || x > grid.nx - 1 - kOnBorder || y > grid.ny - 1 - kOnBorder;
        if (off < 0 && value >= -m_tolerance.below && isOnBorder)
            return; // the stock has no allowance on its own sides
        if (off > 0 && isHidden(facet, place)) {
            out.hiddenMm2 += areaMm2;
            return;
        }
        out.walls.push_back({place, static_cast<float>(value), static_cast<float>(areaMm2),
                             static_cast<int>(std::lround(x)), static_cast<int>(std::lround(y))});
        out.candidates.push_back({place, glm::normalize(normalOf(facet)), off, uncertain});
    }

    /// Whether a place of a face that is not steep is in tolerance along Z already, which is quick to know.
    [[nodiscard]] bool isSeenAlong(std::size_t facet, const Vec3& place, double x, double y) const {
        const Vec3 normal = normalOf(facet);
        if (normal.z < kSteepNormal * glm::length(normal) || m_tolerance.allowance != 0)
            return false;
        const ZMapSnapshot& zmap = m_map.zmap();
        const int i = std::min(static_cast<int>(x), zmap.grid().nx - 2);
        const int j = std::min(static_cast<int>(y), zmap.grid().ny - 2);
        const double wanted = place.z - zmap.stock().topZ();
        const auto isNear = [&](int column, int row) {
            const double off = static_cast<double>(zmap.height(column, row)) - wanted;
            return off <= m_tolerance.above && off >= -m_tolerance.below;
        };
        return isNear(i, j) && isNear(i + 1, j) && isNear(i, j + 1) && isNear(i + 1, j + 1);
    }

    /// Whether other parts of the part are above the air in front of a place, farther than is allowed to be
    /// left there.
    [[nodiscard]] bool isHidden(std::size_t facet, const Vec3& place) const {
        const Vec3 normal = normalOf(facet);
        const double inFront = std::max(m_tolerance.above + m_tolerance.allowance, 0.0) + kExact;
        return m_part.distance().isBelow(place + normal / glm::length(normal) * inFront);
    }

    const MapDistance& m_map;
    const DesignPart& m_part;
    const PartTolerance& m_tolerance;
    std::vector<std::uint32_t> m_facets;
    double m_spacing = 1;
};

std::optional<Deviation> Deviation::of(const ZMapSnapshot& stock, std::shared_ptr<const DesignPart> part,
                                       const PartTolerance& tolerance, const WorkContext& context,
                                       const IsMaterial& isMaterial) {
    Deviation out;
    out.m_part = std::move(part);
    out.m_top = std::make_shared<const PartTop>(*out.m_part, stock.stock(), stock.grid());
    if (context.stopped())
        return std::nullopt;
    context.report(kPrepared / 2);
    out.m_map = std::make_shared<const MapDistance>(stock);
    context.report(kPrepared);
    const Judge judge(*out.m_part, tolerance, isMaterial);
    if (!out.judgePoints(judge, tolerance, context))
        return std::nullopt;
    context.report(kPointsDone);
    if (!out.judgeWalls(judge, tolerance, context))
        return std::nullopt;
    context.report(1);
    return out;
}

bool Deviation::judgePoints(const Judge& judge, const PartTolerance& tolerance, const WorkContext& context) {
    const Points points(*m_map, *m_part, *m_top, tolerance);
    const ZMapSnapshot& stock = m_map->zmap();
    const double uncertain = kUncertainCells * std::max(stock.grid().hx, stock.grid().hy);
    struct OfTile {
        std::shared_ptr<DeviationTile> tile;
        std::vector<Candidate> candidates;
        std::vector<std::pair<std::size_t, float>> instead; ///< of them: the point, and its value otherwise
        std::size_t withoutSide = 0;
    };
    std::vector<OfTile> found(stock.tileCount());
    inParallel(stock.tileCount(), [&](std::size_t index) {
        if (context.stopped())
            return;
        OfTile& of = found[index];
        const IndexRect rect = stock.tileRect(index);
        for (int j = rect.j0; j < rect.j1; ++j)
            for (int i = rect.i0; i < rect.i1; ++i) {
                const Points::Found at = points.at(i, j);
                if (!at.isJudged)
                    continue;
                if (of.tile == nullptr) {
                    of.tile = std::make_shared<DeviationTile>();
                    of.tile->values.fill(kNotJudged);
                }
                of.withoutSide += at.hasSide ? 0 : 1;
                const auto point = static_cast<std::size_t>((j - rect.j0) * Tile::kSize + i - rect.i0);
                of.tile->values[point] = static_cast<float>(at.value);
                if (!at.isOnPart)
                    continue;
                const Vec3 place(stock.grid().x(i), stock.grid().y(j),
                                 stock.stock().topZ() + double{m_top->at(i, j)});
                of.candidates.push_back({place, points.normalAt(place), at.value - tolerance.allowance,
                                         at.isExact ? 0 : uncertain});
                of.instead.emplace_back(point, static_cast<float>(at.ofStock));
            }
    });
    if (context.stopped())
        return false;
    std::vector<Candidate> candidates;
    for (const OfTile& of : found)
        candidates.insert(candidates.end(), of.candidates.begin(), of.candidates.end());
    const auto verdicts = judge.verdicts(candidates);
    std::size_t next = 0;
    m_tiles.resize(found.size());
    for (std::size_t index = 0; index < found.size(); ++index) {
        OfTile& of = found[index];
        for (const auto& [point, value] : of.instead)
            if (verdicts[next++] == Judge::Verdict::in)
                of.tile->values[point] = value;
        m_limits.pointsWithoutSide += of.withoutSide;
        m_tiles[index] = std::move(of.tile);
    }
    return !context.stopped();
}

bool Deviation::judgeWalls(const Judge& judge, const PartTolerance& tolerance, const WorkContext& context) {
    constexpr std::size_t kFacetsOfTask = 16;
    const Walls walls(*m_map, *m_part, tolerance);
    m_limits.wallSpacing = walls.spacing();
    const std::size_t tasks = (walls.facets() + kFacetsOfTask - 1) / kFacetsOfTask;
    std::vector<Walls::OfFacets> found(tasks);
    inParallel(tasks, [&](std::size_t task) {
        const std::size_t first = task * kFacetsOfTask;
        if (!context.stopped())
            walls.look(first, std::min(first + kFacetsOfTask, walls.facets()), found[task]);
    });
    if (context.stopped())
        return false;
    Walls::OfFacets all;
    for (const Walls::OfFacets& of : found) {
        all.hiddenMm2 += of.hiddenMm2;
        all.walls.insert(all.walls.end(), of.walls.begin(), of.walls.end());
        all.candidates.insert(all.candidates.end(), of.candidates.begin(), of.candidates.end());
    }
    m_limits.hiddenMm2 = all.hiddenMm2;
    const auto verdicts = judge.verdicts(all.candidates);
    for (std::size_t k = 0; k < verdicts.size(); ++k) {
        if (verdicts[k] == Judge::Verdict::unknown)
            m_limits.unresolvedMm2 += double{all.walls[k].areaMm2};
        if (verdicts[k] != Judge::Verdict::out)
            continue;
        m_walls.push_back(all.walls[k]);
        // At least what was found out of tolerance.
        const double off = all.candidates[k].off;
        const double least = (off > 0 ? tolerance.above : -tolerance.below) + std::copysign(kExact, off);
        if (std::abs(least) > std::abs(off))
            m_walls.back().value = static_cast<float>(tolerance.allowance + least);
    }
    return !context.stopped();
}

std::optional<Vec3> Deviation::nearestOnStock(const Vec3& place) const {
    const auto nearest = m_map->nearest(place, std::numeric_limits<double>::infinity());
    return nearest ? std::optional(nearest->place) : std::nullopt;
}

float Deviation::at(int i, int j) const {
    const auto index = static_cast<std::size_t>((j / Tile::kSize) * stock().tilesX() + i / Tile::kSize);
    if (m_tiles[index] == nullptr)
        return kNotJudged;
    return m_tiles[index]
        ->values[static_cast<std::size_t>((j % Tile::kSize) * Tile::kSize + i % Tile::kSize)];
}

bool Deviation::isOn(const ZMapSnapshot& moment) const {
    return moment.grid() == grid() && moment.stock() == stock().stock() &&
           moment.tileCount() == stock().tileCount();
}

Deviation::Place Deviation::placeOf(int i, int j) const {
    const PartTolerance none{0, 0, 0};
    const Points points(*m_map, *m_part, *m_top, none);
    const bool isOnPart = points.at(i, j).isOnPart;
    const double height = double{isOnPart ? m_top->at(i, j) : stock().height(i, j)};
    return {{grid().x(i), grid().y(j), stock().stock().topZ() + height}, isOnPart};
}

double Deviation::bytes(const Grid& grid) {
    constexpr double kOfPoint = 2 * sizeof(float) + 1; // part top, value, boxes
    return kOfPoint * grid.nx * grid.ny + kMostSamples * sizeof(WallDeviation);
}

} // namespace proveout
