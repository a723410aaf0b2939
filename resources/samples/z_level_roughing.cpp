// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/samples/z_level_roughing.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "resources/samples/contour.h"

namespace proveout::samples {

namespace {

std::vector<Cell::Row> freeIntervals(const HeightMap& drop, const RoughingPlan& plan, double y,
                                     double level) {
    std::vector<Cell::Row> intervals;
    const int j = drop.rowAt(y);
    bool open = false;
    for (int i = drop.columnAt(plan.lo.x); i <= drop.columnAt(plan.hi.x); ++i) {
        const bool isFree = drop.at(i, j) + plan.allowance <= level;
        if (isFree && !open)
            intervals.push_back({y, drop.x(i), drop.x(i)});
        if (isFree)
            intervals.back().x1 = drop.x(i);
        open = isFree;
    }
    return intervals;
}

bool overlap(const Cell::Row& a, const Cell::Row& b) {
    return a.x0 <= b.x1 && b.x0 <= a.x1;
}

/// The contours of all levels, level by level.
std::vector<std::vector<Polyline>> levelContours(const HeightMap& drop, const RoughingPlan& plan) {
    std::vector<std::vector<Polyline>> levels;
    for (int k = 0; k < plan.levels; ++k) {
        const double level = plan.firstLevel + k * plan.levelStep;
        levels.push_back(contours(drop, level - plan.allowance));
        for (Polyline& loop : levels.back())
            for (Vec3& point : loop)
                point.z = level;
    }
    return levels;
}

std::vector<Polyline> flatten(const std::vector<std::vector<Polyline>>& levels) {
    std::vector<Polyline> all;
    for (const std::vector<Polyline>& level : levels)
        all.insert(all.end(), level.begin(), level.end());
    return all;
}

void retractAndGoTo(ProgramWriter& nc, const RoughingPlan& plan, const Vec3& start) {
    nc.rapid({nc.position().x, nc.position().y, plan.clearanceZ});
    nc.rapid({start.x, start.y, plan.clearanceZ});
    const bool outside = start.x <= plan.outsideLo.x || start.x >= plan.outsideHi.x ||
                         start.y <= plan.outsideLo.y || start.y >= plan.outsideHi.y;
    if (outside) {
        nc.rapid(start);
    } else {
        nc.setFeed(plan.plungeFeed);
        nc.feed(start);
    }
    nc.setFeed(plan.cutFeed);
}

/// Zigzag over one cell. From row to row the cutter steps over where both rows are free.
void writeCell(ProgramWriter& nc, const RoughingPlan& plan, const Cell& cell, double level) {
    bool forward = cell.rows.front().x0 <= plan.outsideLo.x || cell.rows.front().x1 < plan.outsideHi.x;
    const auto from = [&](const Cell::Row& row) { return forward ? row.x0 : row.x1; };
    const auto to = [&](const Cell::Row& row) { return forward ? row.x1 : row.x0; };
    retractAndGoTo(nc, plan, {from(cell.rows.front()), cell.rows.front().y, level});
    for (std::size_t k = 0; k < cell.rows.size(); ++k) {
        const Cell::Row& row = cell.rows[k];
        nc.feed({to(row), row.y, level});
        if (k + 1 == cell.rows.size())
            break;
        const Cell::Row& next = cell.rows[k + 1];
        const double over = forward ? std::min(row.x1, next.x1) : std::max(row.x0, next.x0);
        forward = !forward;
        nc.feed({over, row.y, level});
        nc.feed({over, next.y, level});
        nc.feed({from(next), next.y, level});
    }
}

void writeContour(ProgramWriter& nc, const RoughingPlan& plan, const Polyline& loop) {
    retractAndGoTo(nc, plan, loop.front());
    for (std::size_t k = 1; k < loop.size(); ++k)
        nc.feed(loop[k]);
}

} // namespace

std::vector<Cell> freeCells(const HeightMap& drop, const RoughingPlan& plan, double level) {
    std::vector<Cell> closed;
    std::vector<Cell> open;
    for (double y = plan.lo.y; y <= plan.hi.y; y += plan.rowSpacing) {
        const std::vector<Cell::Row> row = freeIntervals(drop, plan, y, level);
        std::vector<Cell> goesOn;
        for (const Cell::Row& interval : row) {
            const auto touches = [&](const Cell& cell) { return overlap(cell.rows.back(), interval); };
            const auto cell = std::find_if(open.begin(), open.end(), touches);
            const bool oneToOne =
                cell != open.end() && std::count_if(open.begin(), open.end(), touches) == 1 &&
                std::count_if(row.begin(), row.end(),
                              [&](const Cell::Row& other) { return overlap(cell->rows.back(), other); }) == 1;
            goesOn.push_back(oneToOne ? *cell : Cell{});
            goesOn.back().rows.push_back(interval);
        }
        for (Cell& cell : open) {
            const bool continued = std::any_of(goesOn.begin(), goesOn.end(), [&](const Cell& later) {
                return later.rows.size() > 1 && later.rows.front().y == cell.rows.front().y &&
                       later.rows.front().x0 == cell.rows.front().x0;
            });
            if (!continued)
                closed.push_back(std::move(cell));
        }
        open = std::move(goesOn);
    }
    closed.insert(closed.end(), open.begin(), open.end());
    return closed;
}

void writeRoughing(ProgramWriter& nc, const HeightMap& drop, const RoughingPlan& plan,
                   std::size_t contourSegments) {
    const std::vector<std::vector<Polyline>> dense = levelContours(drop, plan);
    const std::vector<Polyline> loops = spendSegments(flatten(dense), contourSegments);
    auto loop = loops.begin();
    for (int k = 0; k < plan.levels; ++k) {
        const double level = plan.firstLevel + k * plan.levelStep;
        nc.comment(fmt::format("LEVEL {} OF {}, Z{:.2f}", k + 1, plan.levels, level));
        for (const Cell& cell : freeCells(drop, plan, level))
            writeCell(nc, plan, cell, level);
        for (std::size_t i = 0; i < dense[static_cast<std::size_t>(k)].size(); ++i)
            writeContour(nc, plan, *loop++);
    }
}

std::size_t contourSegmentsFor(std::size_t blocks, const ProgramWriter& nc, const HeightMap& drop,
                               const RoughingPlan& plan) {
    const std::size_t least = 4 * flatten(levelContours(drop, plan)).size();
    ProgramWriter trial = nc;
    writeRoughing(trial, drop, plan, least);
    return least + blocks - (trial.blocks() - nc.blocks());
}

} // namespace proveout::samples
