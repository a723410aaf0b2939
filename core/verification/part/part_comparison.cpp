// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verification/part/part_comparison.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/simulation/records/block_provenance.h"
#include "core/simulation/records/swept_stock.h"
#include "core/simulation/run/rim_finder.h"
#include "core/simulation/setup/tool_choice.h"

namespace proveout {

namespace {

/// Progress of the steps.
constexpr double kWalled = 0.2;
constexpr double kCompared = 0.8;
constexpr double kOnSurface = 2e-3;    // mm: as blockThatMade() sees it
constexpr double kInFront = 0.01;      // mm: of a surface
constexpr double kBesideRim = 1e-3;    // mm: a point on the rim of a cutter may be beside it
constexpr double kBinsInTolerance = 5; // of the histogram, on each side

/// Finds the block that made each island.
class Blame {
public:
    Blame(const Frame& end, const PartComparison& comparison)
        : m_end(end), m_comparison(comparison), m_tools(*end.program, *end.setup) {}

    void apply(std::vector<ComparedIsland>& islands, const WorkContext& context) {
        const std::size_t count = std::min(islands.size(), PartComparison::kMostBlamed);
        for (std::size_t k = 0; k < count; ++k)
            add(islands[k].of, k);
        const auto blocks = blocksThatMade(*m_end.program, *m_end.setup, m_end.block, m_places, context);
        for (std::size_t k = 0; k < blocks.size(); ++k)
            if (ComparedIsland& island = islands[m_owners[k]]; blocks[k] && !island.block)
                note(island, *blocks[k]);
        for (std::size_t k = 0; k < count; ++k)
            islands[k].isUncut = !islands[k].block;
    }

private:
    void note(ComparedIsland& island, std::size_t block) const {
        island.block = block;
        island.line = static_cast<int>(m_end.program->blockLine(block));
        island.tool = m_tools.tool(m_end.program->motion(m_end.program->blockMotions(block).last - 1).tool);
    }

    /// The places whose blocks may have made an island, the best first.
    void add(const Island& island, std::size_t owner) {
        if (island.kind == IslandKind::gouge && island.isOnPart)
            addAround(missingPlace(island), owner); // if nobody came there, the one below is as good
        addSurface(island, owner);
    }

    /// Who made the surface at the nearest place of the stock, or else at the nearest point of the grid.
    void addSurface(const Island& island, std::size_t owner) {
        if (island.kind == IslandKind::excess && island.isOnPart)
            if (const auto nearest = m_comparison.deviation.nearestOnStock(island.place);
                nearest && *nearest != island.place) {
                // Just in the air in front of it.
                addAround(*nearest + glm::normalize(*nearest - island.place) * kInFront, owner);
                return;
            }
        const ZMapSnapshot& zmap = m_comparison.deviation.stock();
        const Grid& grid = zmap.grid();
        if (isCut(m_end, {island.i, island.j}))
            addAround(Vec3(grid.x(island.i), grid.y(island.j),
                           zmap.stock().topZ() + double{zmap.height(island.i, island.j)}),
                      owner);
    }

    /// A place within the part, deeper than allowed, where nothing is left: who came there first is to blame.
    [[nodiscard]] Vec3 missingPlace(const Island& island) const {
        const double depth = (island.depthMm + m_comparison.tolerance.below) / 2;
        const DesignPart& part = m_comparison.deviation.part();
        const auto nearest = part.distance().at(island.place);
        const std::array<Vec3, 3> at = part.corners(nearest->facet);
        return island.place - glm::normalize(glm::cross(at[1] - at[0], at[2] - at[0])) * depth;
    }

    void addAround(const Vec3& place, std::size_t owner) {
        for (const Vec2 aside : {Vec2(0, 0), Vec2(kBesideRim, kBesideRim), Vec2(-kBesideRim, -kBesideRim),
                                 Vec2(kBesideRim, -kBesideRim), Vec2(-kBesideRim, kBesideRim)}) {
            m_places.push_back(place + Vec3(aside, 0));
            m_owners.push_back(owner);
        }
    }

    const Frame& m_end;
    const PartComparison& m_comparison;
    ToolChoice m_tools;
    std::vector<Vec3> m_places;
    std::vector<std::size_t> m_owners; ///< of the places: islands
};

void count(PartComparison& comparison) {
    const PartTolerance& tolerance = comparison.tolerance;
    DeviationHistogram& histogram = comparison.histogram;
    const double narrowest = std::max(std::min(tolerance.below, tolerance.above), kOnSurface);
    histogram.width = narrowest / (kBinsInTolerance - 0.5); // the tolerance is between two bins
    bool isFirst = true;
    const auto note = [&](double off) {
        if (std::exchange(isFirst, false))
            comparison.lowestMm = comparison.highestMm = off;
        comparison.lowestMm = std::min(comparison.lowestMm, off);
        comparison.highestMm = std::max(comparison.highestMm, off);
    };
    constexpr int kLast = DeviationHistogram::kBins - 1;
    for (std::size_t index = 0; index < comparison.deviation.tileCount(); ++index) {
        const auto& tile = comparison.deviation.tile(index);
        if (tile == nullptr)
            continue;
        for (const float value : tile->values) {
            if (std::isnan(value))
                continue;
            const double off = double{value} - tolerance.allowance;
            note(off);
            ++comparison.judgedPoints;
            const double bin = std::round(off / histogram.width) + DeviationHistogram::kMiddle;
            ++histogram.points[static_cast<std::size_t>(std::clamp<double>(bin, 0, kLast))];
        }
    }
    for (const WallDeviation& wall : comparison.deviation.walls())
        note(double{wall.value} - tolerance.allowance);
}

} // namespace

std::shared_ptr<const PartComparison> comparePart(const Frame& end, std::shared_ptr<const DesignPart> part,
                                                  const PartTolerance& tolerance,
                                                  const WorkContext& context) {
    ZMapSnapshot walled = end.zmap;
    if (walled.rims().empty())
        walled = RimFinder().find(end, context.part(0, kWalled));
    auto comparison = std::make_shared<PartComparison>();
    comparison->tolerance = tolerance;
    PartTolerance judged = tolerance; // nothing is known more exactly
    judged.below = std::max(judged.below, kOnSurface);
    judged.above = std::max(judged.above, kOnSurface);
    const SweptStock swept(end, context.quiet());
    const auto isMaterial = [&](std::span<const Vec3> places) {
        return swept.isMaterial(places, context.quiet());
    };
    auto deviation =
        Deviation::of(walled, std::move(part), judged, context.part(kWalled, kCompared), isMaterial);
    if (!deviation || context.stopped())
        return nullptr;
    comparison->deviation = std::move(*deviation);
    count(*comparison);
    for (Island& island : islandsOf(comparison->deviation, judged)) {
        const bool isGouge = island.kind == IslandKind::gouge;
        ++(isGouge ? comparison->gouges : comparison->excesses);
        (isGouge ? comparison->missingMm3 : comparison->leftMm3) += island.volumeMm3;
        if (comparison->islands.size() < PartComparison::kMostIslands)
            comparison->islands.push_back({.of = island});
    }
    Blame(end, *comparison).apply(comparison->islands, context.part(kCompared, 1));
    return context.stopped() ? nullptr : comparison;
}

double comparisonBytes(const Grid& grid) {
    constexpr double kOfPoint = 40; // of an island, if all of them are out of tolerance
    return Deviation::bytes(grid) + kOfPoint * grid.nx * grid.ny;
}

double overlap(const DesignPart& part, const StockBox& stock) {
    const Vec3 low(stock.corner.x, stock.corner.y, stock.floorZ());
    const Vec3 high(stock.corner.x + stock.width, stock.corner.y + stock.depth, stock.topZ());
    double fraction = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const double size = part.box().hi[axis] - part.box().lo[axis];
        const double within =
            std::min(part.box().hi[axis], high[axis]) - std::max(part.box().lo[axis], low[axis]);
        fraction *= size > 0 ? std::max(within, 0.0) / size : 1;
    }
    return fraction;
}

} // namespace proveout
