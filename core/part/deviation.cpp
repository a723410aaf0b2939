// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/part/deviation.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
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
/// Faces are upright down to here; below they face downwards.
constexpr double kUprightNormal = -1e-6;
/// Heights of the map are exact to 1 µm, and in single precision as are those of the part.
constexpr double kSameHeight = 2e-6; // mm
/// Where a step of the grid has no rim, its wall is somewhere in a cell.
constexpr double kUncertainCells = 0.75;

/// A bound that rounding does not make too small.
double atMost(double distance) {
    return distance * (1 + 1e-9) + 1e-6;
}

} // namespace

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
    };

    [[nodiscard]] Found at(int i, int j) const {
        const double top = double{m_top.at(i, j)};
        if (top == double{PartTop::kNone})
            return {};
        const ZMapSnapshot& zmap = m_map.zmap();
        const double left = double{zmap.height(i, j)} - top; // stock over the part
        Found found = fromStock(i, j, left);
        const bool isWithin = isAllowed(left) && isAllowed(found.value);
        if (isWithin || (found.isPlain && !isAllowed(found.value)))
            return found;
        // The other direction: this place of the part may be farther from the stock.
        const Grid& grid = zmap.grid();
        const Vec3 place(grid.x(i), grid.y(j), zmap.stock().topZ() + top);
        const auto nearest = m_map.nearest(place, atMost(std::abs(left)));
        const double away = nearest ? nearest->distance : std::abs(left);
        if (away > std::abs(found.value))
            found = {std::copysign(away, left), true, true, true, false};
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
            return {left, false, true, true, false};
        Found found{place->distance, false, true, true, isOfSlope(*place, left)};
        const bool isSame = std::abs(place->distance) <= kSameHeight;
        // Over the highest place of the part no point is within it. Below, a point outside is beneath an
        // overhang that is gone, or on a wall: the other direction tells.
        const bool contradicts = left > kSameHeight && place->distance < -kSameHeight;
        if (!isSame && (!place->hasSide || contradicts))
            return {std::copysign(std::abs(place->distance), left), false, true, false, false};
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

    void look(std::size_t first, std::size_t last, std::vector<WallDeviation>& out,
              DeviationLimits& limits) const {
        for (std::size_t k = first; k < last; ++k)
            eachSample(m_facets[k], [&](const Vec3& place, double areaMm2) {
                lookAt(m_facets[k], place, areaMm2, out, limits);
            });
    }
    [[nodiscard]] std::size_t facets() const { return m_facets.size(); }
    [[nodiscard]] double spacing() const { return m_facets.empty() ? 0 : m_spacing; }

private:
    [[nodiscard]] Vec3 normalOf(std::size_t facet) const {
        const std::array<Vec3, 3> at = m_part.corners(facet);
        return glm::cross(at[1] - at[0], at[2] - at[0]) / 2.0;
    }
    /// 0 if it is not steep, or faces downwards.
    [[nodiscard]] double areaOf(std::size_t facet) const {
        const Vec3 normal = normalOf(facet);
        const double area = glm::length(normal);
        return area > 0 && normal.z < kSteepNormal * area && normal.z >= kUprightNormal * area ? area : 0;
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
        for (int row = 0; row < rows; ++row) {
            const double begin = static_cast<double>(row) / rows;
            const double end = static_cast<double>(row + 1) / rows;
            const double middle = (begin + end) / 2;
            const int samples = steps(length * (1 - middle));
            const double areaOfRow = area * ((1 - begin) * (1 - begin) - (1 - end) * (1 - end));
            const Vec3 first = glm::mix(at[0], at[2], middle);
            const Vec3 last = glm::mix(at[1], at[2], middle);
            for (int k = 0; k < samples; ++k)
                visit(glm::mix(first, last, (k + 0.5) / samples), areaOfRow / samples);
        }
    }

    void lookAt(std::size_t facet, const Vec3& place, double areaMm2, std::vector<WallDeviation>& out,
                DeviationLimits& limits) const {
        const ZMapSnapshot& zmap = m_map.zmap();
        const Grid& grid = zmap.grid();
        const double x = (place.x - grid.x0) / grid.hx;
        const double y = (place.y - grid.y0) / grid.hy;
        if (x < 0 || y < 0 || x > grid.nx - 1 || y > grid.ny - 1)
            return; // beside the stock: told as such
        const auto nearest = m_map.nearest(place, std::numeric_limits<double>::infinity());
        if (!nearest)
            return;
        const double value = nearest->isInside ? nearest->distance : -nearest->distance;
        const double off = value - m_tolerance.allowance;
        if (off <= m_tolerance.above && off >= -m_tolerance.below)
            return;
        const double uncertain = nearest->isSharp ? 0 : kUncertainCells * std::max(grid.hx, grid.hy);
        if (off - uncertain <= m_tolerance.above && off + uncertain >= -m_tolerance.below) {
            limits.unresolvedMm2 += areaMm2;
            return;
        }
        if (off > 0 && isHidden(facet, place)) {
            limits.hiddenMm2 += areaMm2;
            return;
        }
        out.push_back({place, static_cast<float>(value), static_cast<float>(areaMm2),
                       static_cast<int>(std::lround(x)), static_cast<int>(std::lround(y))});
    }

    /// Whether other parts of the part are above the air in front of a place.
    [[nodiscard]] bool isHidden(std::size_t facet, const Vec3& place) const {
        constexpr double kInFront = 1e-3; // mm
        const Vec3 normal = normalOf(facet);
        return m_part.distance().isBelow(place + normal / glm::length(normal) * kInFront);
    }

    const MapDistance& m_map;
    const DesignPart& m_part;
    const PartTolerance& m_tolerance;
    std::vector<std::uint32_t> m_facets;
    double m_spacing = 1;
};

std::optional<Deviation> Deviation::of(const ZMapSnapshot& stock, std::shared_ptr<const DesignPart> part,
                                       const PartTolerance& tolerance, const WorkContext& context) {
    constexpr std::size_t kFacetsOfTask = 16;
    Deviation out;
    out.m_part = std::move(part);
    out.m_top = std::make_shared<const PartTop>(*out.m_part, stock.stock(), stock.grid());
    if (context.stopped())
        return std::nullopt;
    context.report(kPrepared / 2);
    out.m_map = std::make_shared<const MapDistance>(stock);
    context.report(kPrepared);
    out.m_tiles.resize(stock.tileCount());
    const Points points(*out.m_map, *out.m_part, *out.m_top, tolerance);
    std::atomic<std::size_t> withoutSide = 0;
    inParallel(stock.tileCount(), [&](std::size_t index) {
        if (context.stopped())
            return;
        auto tile = std::make_shared<DeviationTile>();
        tile->values.fill(kNotJudged);
        bool isJudged = false;
        const IndexRect rect = stock.tileRect(index);
        for (int j = rect.j0; j < rect.j1; ++j)
            for (int i = rect.i0; i < rect.i1; ++i) {
                const Points::Found found = points.at(i, j);
                if (!found.isJudged)
                    continue;
                isJudged = true;
                withoutSide += found.hasSide ? 0 : 1;
                tile->values[static_cast<std::size_t>((j - rect.j0) * Tile::kSize + i - rect.i0)] =
                    static_cast<float>(found.value);
            }
        if (isJudged)
            out.m_tiles[index] = std::move(tile);
    });
    context.report(kPointsDone);
    out.m_limits.pointsWithoutSide = withoutSide;
    const Walls walls(*out.m_map, *out.m_part, tolerance);
    out.m_limits.wallSpacing = walls.spacing();
    const std::size_t tasks = (walls.facets() + kFacetsOfTask - 1) / kFacetsOfTask;
    struct OfTask {
        std::vector<WallDeviation> walls;
        DeviationLimits limits;
    };
    std::vector<OfTask> found(tasks);
    inParallel(tasks, [&](std::size_t task) {
        const std::size_t first = task * kFacetsOfTask;
        if (!context.stopped())
            walls.look(first, std::min(first + kFacetsOfTask, walls.facets()), found[task].walls,
                       found[task].limits);
    });
    for (OfTask& task : found) {
        out.m_walls.insert(out.m_walls.end(), task.walls.begin(), task.walls.end());
        out.m_limits.hiddenMm2 += task.limits.hiddenMm2;
        out.m_limits.unresolvedMm2 += task.limits.unresolvedMm2;
    }
    if (context.stopped())
        return std::nullopt;
    context.report(1);
    return out;
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
