// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/records/block_provenance.h"

#include <algorithm>
#include <array>
#include <vector>

#include "core/base/parallel.h"
#include "core/simulation/records/reached_place.h"
#include "core/simulation/run/block_cutter.h"
#include "core/simulation/setup/tool_choice.h"
#include "core/zmap/grid_part.h"

namespace proveout {

namespace {

/// Blocks that are cut at once: their motions need some 10 MB.
constexpr std::size_t kPortion = 65'536;
/// A point on the rim of a cutter is cut, but rounding may place it beside the rim.
constexpr double kBesideRim = 1e-3; // mm

} // namespace

std::optional<Provenance> blockProvenance(const ZMapSnapshot& uncut, const Program& program,
                                          const Setup& setup, std::size_t blocks,
                                          const WorkContext& context) {
    const ToolChoice tools(program, setup);
    ZMap zmap(uncut);
    Provenance provenance(zmap);
    for (std::size_t first = 0; first < blocks; first += kPortion) {
        const std::size_t last = std::min(first + kPortion, blocks);
        const auto motions = cutterMotions(program, first, last, setup, tools);
        if (!cut(zmap, motions, context.stop, &provenance))
            return std::nullopt;
        context.report(static_cast<double>(last) / static_cast<double>(blocks));
    }
    return provenance;
}

double provenanceBytes(const Grid& grid) {
    return zmapBytes(grid) + Provenance::bytes(grid);
}

std::vector<std::optional<std::size_t>> blocksThatMade(const Program& program, const Setup& setup,
                                                       std::size_t blocks, std::span<const Vec3> places,
                                                       const WorkContext& context) {
    constexpr std::size_t kBetweenLooks = 1024;
    const ToolChoice tools(program, setup);
    std::vector<std::optional<std::size_t>> made(places.size());
    const auto isKnown = [](const std::optional<std::size_t>& block) { return block.has_value(); };
    for (std::size_t first = 0; first < blocks && !context.stopped(); first += kBetweenLooks) {
        const std::size_t last = std::min(first + kBetweenLooks, blocks);
        const auto motions = cutterMotions(program, first, last, setup, tools);
        inParallel(places.size(), [&](std::size_t k) {
            for (std::size_t n = 0; n < motions.size() && !made[k]; ++n)
                if (reaches(motions[n], places[k]))
                    made[k] = motions[n].mark - 1;
        });
        if (std::ranges::all_of(made, isKnown))
            break;
        context.report(static_cast<double>(last) / static_cast<double>(blocks));
    }
    return made;
}

std::optional<std::size_t> blockThatMade(const Program& program, const Setup& setup, std::size_t blocks,
                                         const Vec3& place, const WorkContext& context) {
    return blocksThatMade(program, setup, blocks, {&place, 1}, context).front();
}

bool isCut(const Frame& moment, const MapPoint& point) {
    GridPart cell(moment.zmap.grid());
    const MapPoint corner{std::min(point.i, cell.nx - 2), std::min(point.j, cell.ny - 2)};
    cell.firstI = corner.i;
    cell.firstJ = corner.j;
    cell.nx = cell.ny = 2;
    const ZMap uncut = uncutPart(moment.setup->stock, moment.setup->shape, cell);
    const double before = uncut.tile(0).at(point.i - corner.i, point.j - corner.j);
    return double{moment.zmap.height(point.i, point.j)} < before - kOnSurface;
}

std::optional<std::size_t> blockThatMade(const Frame& moment, const MapPoint& point,
                                         const WorkContext& context) {
    if (!isCut(moment, point))
        return std::nullopt;
    const Grid& grid = moment.zmap.grid();
    const Vec3 place(grid.x(point.i), grid.y(point.j),
                     moment.zmap.stock().topZ() + double{moment.zmap.height(point.i, point.j)});
    const std::array asides{Vec2(0, 0), Vec2(kBesideRim, kBesideRim), Vec2(-kBesideRim, -kBesideRim),
                            Vec2(kBesideRim, -kBesideRim), Vec2(-kBesideRim, kBesideRim)};
    for (std::size_t k = 0; k < asides.size() && !context.stopped(); ++k) {
        const auto block = blockThatMade(*moment.program, *moment.setup, moment.block,
                                         place + Vec3(asides[k], 0), k == 0 ? context : context.quiet());
        if (block)
            return block;
    }
    return std::nullopt;
}

} // namespace proveout
