// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/part/deviation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/parallel.h"
#include "core/part/place_judge.h"
#include "core/part/point_deviations.h"
#include "core/part/wall_samples.h"

namespace proveout {

namespace {

/// Progress of the steps.
constexpr double kPrepared = 0.2;
constexpr double kPointsDone = 0.8;

} // namespace

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
    const PlaceJudge judge(*out.m_part, tolerance, isMaterial);
    if (!out.judgePoints(judge, tolerance, context))
        return std::nullopt;
    context.report(kPointsDone);
    if (!out.judgeWalls(judge, tolerance, context))
        return std::nullopt;
    context.report(1);
    return out;
}

bool Deviation::judgePoints(const PlaceJudge& judge, const PartTolerance& tolerance,
                            const WorkContext& context) {
    const PointDeviations points(*m_map, *m_part, *m_top, tolerance);
    const ZMapSnapshot& stock = m_map->zmap();
    const double uncertain = kUncertainCells * std::max(stock.grid().hx, stock.grid().hy);
    struct OfTile {
        std::shared_ptr<DeviationTile> tile;
        std::vector<PartPlace> candidates;
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
                const PointDeviations::Found at = points.at(i, j);
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
    std::vector<PartPlace> candidates;
    for (const OfTile& of : found)
        candidates.insert(candidates.end(), of.candidates.begin(), of.candidates.end());
    const auto verdicts = judge.verdicts(candidates);
    std::size_t next = 0;
    m_tiles.resize(found.size());
    for (std::size_t index = 0; index < found.size(); ++index) {
        OfTile& of = found[index];
        for (const auto& [point, value] : of.instead)
            if (const PlaceJudge::Verdict verdict = verdicts[next++]; verdict != PlaceJudge::Verdict::out) {
                of.tile->values[point] = value;
                m_limits.pointsWithoutSide += verdict == PlaceJudge::Verdict::unknown ? 1 : 0;
            }
        m_limits.pointsWithoutSide += of.withoutSide;
        m_tiles[index] = std::move(of.tile);
    }
    return !context.stopped();
}

bool Deviation::judgeWalls(const PlaceJudge& judge, const PartTolerance& tolerance,
                           const WorkContext& context) {
    constexpr std::size_t kFacetsOfTask = 16;
    const WallSamples walls(*m_map, *m_part, tolerance);
    m_limits.wallSpacing = walls.spacing();
    const std::size_t tasks = (walls.facets() + kFacetsOfTask - 1) / kFacetsOfTask;
    std::vector<WallSamples::OfFacets> found(tasks);
    inParallel(tasks, [&](std::size_t task) {
        const std::size_t first = task * kFacetsOfTask;
        if (!context.stopped())
            walls.look(first, std::min(first + kFacetsOfTask, walls.facets()), found[task]);
    });
    if (context.stopped())
        return false;
    WallSamples::OfFacets all;
    for (const WallSamples::OfFacets& of : found) {
        all.hiddenMm2 += of.hiddenMm2;
        all.walls.insert(all.walls.end(), of.walls.begin(), of.walls.end());
        all.candidates.insert(all.candidates.end(), of.candidates.begin(), of.candidates.end());
    }
    m_limits.hiddenMm2 = all.hiddenMm2;
    const auto verdicts = judge.verdicts(all.candidates);
    for (std::size_t k = 0; k < verdicts.size(); ++k) {
        if (verdicts[k] == PlaceJudge::Verdict::unknown)
            m_limits.unresolvedMm2 += double{all.walls[k].areaMm2};
        if (verdicts[k] != PlaceJudge::Verdict::out)
            continue;
        m_walls.push_back(all.walls[k]);
        // At least what was found out of tolerance.
        const double off = all.candidates[k].off;
        const double least =
            (off > 0 ? tolerance.above : -tolerance.below) + std::copysign(kExactVolume, off);
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
    const PointDeviations points(*m_map, *m_part, *m_top, none);
    const bool isOnPart = points.at(i, j).isOnPart;
    const double height = double{isOnPart ? m_top->at(i, j) : stock().height(i, j)};
    return {{grid().x(i), grid().y(j), stock().stock().topZ() + height}, isOnPart};
}

double Deviation::bytes(const Grid& grid) {
    constexpr double kOfPoint = 2 * sizeof(float) + 1; // part top, value, boxes
    return kOfPoint * grid.nx * grid.ny + WallSamples::kMostSamples * sizeof(WallDeviation);
}

} // namespace proveout
