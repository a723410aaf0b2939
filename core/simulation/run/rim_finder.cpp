// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/run/rim_finder.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include "core/base/parallel.h"
#include "core/cutting/cut/tile_rims.h"
#include "core/cutting/cut/unseen_ribs.h"
#include "core/simulation/run/block_cutter.h"
#include "core/simulation/run/frame.h"

namespace proveout {

namespace {

constexpr std::uint32_t kUnknown = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t kMotionsOfLook = 1024;
/// Tiles between two reports of progress.
constexpr std::size_t kPortion = 256;
/// Tiles between two looks at the clock.
constexpr std::size_t kPortionInTime = 4;
/// The most motions over a tile that is looked at while the program is played: some milliseconds.
constexpr std::size_t kMotionsInTime = 2000;

RimTilePtr withUnseenRibs(RimTilePtr rims, std::vector<std::uint16_t> edges) {
    if (edges.empty())
        return rims;
    RimTile all = rims == nullptr ? RimTile{} : *rims;
    all.unseenRibs = std::move(edges);
    return std::make_shared<const RimTile>(std::move(all));
}

std::size_t motionsOf(const Program& program, std::size_t blocks) {
    return blocks == 0 ? 0 : program.blockMotions(blocks - 1).last;
}

} // namespace

ZMapSnapshot RimFinder::find(const Frame& moment, const WorkContext& context) {
    const std::size_t motions = begin(moment);
    ZMapSnapshot zmap = moment.zmap;
    const bool done = readMotions(motions, context.stop) && findTiles(zmap, motions, context);
    if (!done)
        return zmap;
    zmap.setRims(m_rims);
    makeWalls(zmap, m_rims);
    return zmap;
}

WallPoints RimFinder::findSome(const Frame& moment, std::chrono::nanoseconds time) {
    const Clock::time_point until = Clock::now() + time;
    const std::size_t motions = begin(moment);
    if (!readMotions(motions, {}, until))
        return {};
    std::vector<std::size_t> unknown = outdatedTiles(motions);
    findUntil(moment.zmap, motions, until, unknown);
    RimMap known = m_rims;
    for (const std::size_t tile : unknown)
        if (std::as_const(known)[tile] != nullptr)
            known.edit(tile) = nullptr;
    ZMapSnapshot zmap = moment.zmap;
    zmap.setRims(known);
    makeWalls(zmap, known);
    return m_walls;
}

std::size_t RimFinder::begin(const Frame& moment) {
    if (m_setup != moment.setup)
        restart(moment);
    else if (m_program != moment.program)
        follow(moment);
    return motionsOf(*m_program, moment.block);
}

void RimFinder::makeWalls(ZMapSnapshot& zmap, const RimMap& rims) {
    m_walls = WallPoints(zmap, std::exchange(m_rimsOfWalls, rims), m_walls);
    zmap.setWalls(m_walls);
}

void RimFinder::restart(const Frame& moment) {
    const ZMapSnapshot& zmap = moment.zmap;
    const StockShape& shape = moment.setup->shape;
    m_uncut = shape.body == nullptr ? nullptr
              : m_part              ? topOfPart(moment.setup->stock, shape, *m_part)
                                    : topOf(zmap.stock(), shape, zmap.grid());
    m_index = MotionIndex(zmap.stock(), zmap.grid());
    m_rims = RimMap(zmap.tileCount());
    m_rimsOfWalls = {};
    m_walls = {};
    m_ends.assign(zmap.tileCount(), kUnknown);
    m_tools = ToolChoice(*moment.program, *moment.setup);
    m_program = moment.program;
    m_setup = moment.setup;
}

void RimFinder::follow(const Frame& moment) {
    const ToolChoice tools(*moment.program, *m_setup);
    // A different tool in the spindle changes every block, though no block reads differently.
    const std::size_t kept =
        tools.assumed() == m_tools.assumed() ? m_program->firstDifference(*moment.program) : 0;
    const std::size_t motions = motionsOf(*moment.program, kept);
    m_index.truncate(motions);
    for (std::uint32_t& end : m_ends)
        if (end > motions)
            end = kUnknown;
    m_tools = tools;
    m_program = moment.program;
}

bool RimFinder::readMotions(std::size_t motions, const std::stop_token& stop, Clock::time_point until) {
    while (m_index.motionCount() < motions && !stop.stop_requested() && Clock::now() < until) {
        const std::size_t first = m_index.motionCount();
        eachCutterMotion(*m_program, {first, std::min(first + kMotionsOfLook, motions)}, *m_setup, m_tools,
                         [&](const CutterMotion& motion) { m_index.append(motion); });
    }
    return m_index.motionCount() >= motions;
}

bool RimFinder::findTiles(const ZMapSnapshot& zmap, std::size_t motions, const WorkContext& context) {
    const std::vector<std::size_t> tiles = outdatedTiles(motions);
    std::vector<RimTilePtr> found(kPortion);
    for (std::size_t first = 0; first < tiles.size(); first += kPortion) {
        const auto portion = std::span(tiles).subspan(first, std::min(kPortion, tiles.size() - first));
        inParallel(portion.size(),
                   [&](std::size_t k) { found[k] = rimsOf(zmap, portion[k], motions, context.stop); });
        if (context.stopped())
            return false;
        for (std::size_t k = 0; k < portion.size(); ++k)
            adopt(portion[k], std::move(found[k]), m_index.endOver(portion[k], motions));
        context.report(static_cast<double>(first + portion.size()) / static_cast<double>(tiles.size()));
    }
    return true;
}

void RimFinder::findUntil(const ZMapSnapshot& zmap, std::size_t motions, Clock::time_point until,
                          std::vector<std::size_t>& tiles) {
    std::rotate(tiles.begin(), std::ranges::lower_bound(tiles, m_nextTile), tiles.end());
    std::vector<std::size_t> left;
    std::vector<std::size_t> portion;
    std::vector<RimTilePtr> found(kPortionInTime);
    auto next = tiles.begin();
    while (next != tiles.end() && Clock::now() < until) {
        portion.clear();
        for (; next != tiles.end() && portion.size() < kPortionInTime && Clock::now() < until; ++next)
            (isQuick(*next, motions) ? portion : left).push_back(*next);
        inParallel(portion.size(), [&](std::size_t k) { found[k] = rimsOf(zmap, portion[k], motions, {}); });
        for (std::size_t k = 0; k < portion.size(); ++k) {
            adopt(portion[k], std::move(found[k]), m_index.endOver(portion[k], motions));
            m_nextTile = portion[k] + 1;
        }
    }
    left.insert(left.end(), next, tiles.end());
    tiles = std::move(left);
}

bool RimFinder::isQuick(std::size_t tile, std::size_t motions) const {
    std::size_t over = 0;
    for (const Program::MotionRange& range : m_index.over(tile, motions))
        over += range.last - range.first;
    return over <= kMotionsInTime;
}

std::vector<std::size_t> RimFinder::outdatedTiles(std::size_t motions) const {
    std::vector<std::size_t> tiles;
    for (std::size_t tile = 0; tile < m_ends.size(); ++tile)
        if (m_index.endOver(tile, motions) != m_ends[tile])
            tiles.push_back(tile);
    return tiles;
}

RimTilePtr RimFinder::rimsOf(const ZMapSnapshot& zmap, std::size_t tile, std::size_t motions,
                             const std::stop_token& stop) const {
    const auto ranges = m_index.over(tile, motions);
    const bool isUncutBox = ranges.empty() && m_uncut == nullptr;
    if (stop.stop_requested() || isUncutBox)
        return nullptr;
    TileRimSearch search(zmap, tile, RimEdges::atLevels);
    UnseenRibs ribs(zmap, tile, m_uncut == nullptr ? nullptr : m_uncut->rims(tile));
    const auto eachMotion = [&](const auto& visit) {
        for (const Program::MotionRange& range : ranges)
            for (std::size_t first = range.first; first < range.last && !search.isFull();
                 first += kMotionsOfLook)
                eachCutterMotion(*m_program, {first, std::min(first + kMotionsOfLook, range.last)}, *m_setup,
                                 m_tools, visit);
    };
    if (!search.hasNone() || !ribs.hasNone())
        eachMotion([&](const CutterMotion& motion) {
            search.add(motion);
            ribs.add(motion);
        });
    RimTilePtr rims = search.find(m_uncut.get(), stop);
    if (ribs.hasNone() || search.isFull() || stop.stop_requested() || !ribs.suspects(m_uncut.get()))
        return rims;
    eachMotion([&](const CutterMotion& motion) { ribs.lower(motion); });
    return withUnseenRibs(std::move(rims), ribs.edges());
}

void RimFinder::adopt(std::size_t tile, RimTilePtr rims, std::size_t end) {
    m_ends[tile] = static_cast<std::uint32_t>(end);
    // Equal rims too, because heights beside them may be others: walls are compared as such.
    if (rims != nullptr || std::as_const(m_rims)[tile] != nullptr)
        m_rims.edit(tile) = std::move(rims);
}

} // namespace proveout
