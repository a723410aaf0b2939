// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/records/box_of_interest.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <utility>
#include <vector>

#include "core/base/figures_argument.h"
#include "core/base/memory.h"
#include "core/base/stop_watch.h"
#include "core/cutting/cut/cut_part.h"
#include "core/simulation/records/detail_findings.h"
#include "core/simulation/run/block_cutter.h"
#include "core/simulation/run/frame.h"
#include "core/simulation/run/rim_finder.h"
#include "core/simulation/setup/tool_choice.h"
#include "core/zmap/zmap_findings.h"

namespace proveout {

namespace {

constexpr std::size_t kBlocksOfLook = 1024;
/// Motions near the box that are cut at once.
constexpr std::size_t kPortion = 16'384;
constexpr double kRim = 1e-6; // mm; a point on the rim of a cutter is cut

/// The volume of a part in which motions may lower points.
class Neighbourhood {
public:
    Neighbourhood(const GridPart& part, double topZ)
        : m_lo(part.x(0) - kRim, part.y(0) - kRim),
          m_hi(part.x(part.nx - 1) + kRim, part.y(part.ny - 1) + kRim), m_topZ(topZ) {}

    [[nodiscard]] bool isReachedBy(const CutterMotion& one) const {
        if (one.cutter == nullptr || !one.motion.known() || !withinLimits(one.motion))
            return false;
        const Box3 path = bounds(one.motion);
        const double radius = one.cutter->radius();
        return path.lo.z < m_topZ && path.lo.x - radius <= m_hi.x && path.hi.x + radius >= m_lo.x &&
               path.lo.y - radius <= m_hi.y && path.hi.y + radius >= m_lo.y;
    }

private:
    Vec2 m_lo;
    Vec2 m_hi;
    double m_topZ;
};

/// The points of a map from (i0, j0) on, as a separate map.
ZMapSnapshot cropped(const ZMapSnapshot& map, int i0, int j0, const StockBox& stock, const Grid& grid) {
    ZMap out(stock, grid);
    std::vector<float> row(Tile::kSize);
    for (std::size_t index = 0; index < out.tileCount(); ++index) {
        const IndexRect rect = out.tileRect(index);
        Tile& tile = out.tileForWriting(index);
        for (int j = rect.j0; j < rect.j1; ++j) {
            map.read({i0 + rect.i0, j0 + j, i0 + rect.i1, j0 + j + 1}, row);
            std::copy_n(row.begin(), rect.width(), &tile.at(0, j - rect.j0));
        }
        tile.refreshMaximum();
    }
    return out.snapshot();
}

/// Cuts those of the first `blocks` blocks that come near; returns how many motions these were, or nothing if
/// it was stopped.
std::optional<std::size_t> cutNear(ZMap& zmap, const GridPart& place, const Neighbourhood& near,
                                   const Program& program, const Setup& setup, std::size_t blocks,
                                   const WorkContext& context) {
    const ToolChoice tools(program, setup);
    std::vector<CutterMotion> motions;
    std::size_t count = 0;
    for (std::size_t first = 0; first < blocks; first += kBlocksOfLook) {
        const std::size_t last = std::min(first + kBlocksOfLook, blocks);
        std::ranges::copy_if(cutterMotions(program, first, last, setup, tools), std::back_inserter(motions),
                             [&](const CutterMotion& one) { return near.isReachedBy(one); });
        if (context.stopped())
            return std::nullopt;
        if (motions.size() < kPortion && last < blocks)
            continue;
        if (!cutHeights(zmap, place, motions, context.stop))
            return std::nullopt;
        count += motions.size();
        motions.clear();
        context.report(static_cast<double>(last) / static_cast<double>(blocks));
    }
    return count;
}

/// The memory of a map in whole tiles while the part is cut, and then of the points in the box, with their
/// meshes.
double bytesOf(const GridPart& part, double bytesPerPoint) {
    return zmapBytes(part.inWholeTiles().grid()) + zmapBytes(part.grid()) +
           static_cast<double>(part.nx) * part.ny * bytesPerPoint;
}

/// To three digits; nothing if the coarsest spacing does not fit.
template<class Fits>
std::optional<double> finestThatFits(const BoxOfInterest& box, const Fits& fits) {
    double fine = box.spacing;
    double coarse = std::min(box.box.hi.x - box.box.lo.x, box.box.hi.y - box.box.lo.y);
    if (!fits(coarse))
        return {};
    for (int step = 0; step < 60; ++step) {
        const double middle = std::sqrt(fine * coarse);
        (fits(middle) ? coarse : fine) = middle;
    }
    const double digit = std::pow(10.0, std::floor(std::log10(coarse)) - 2);
    double rounded = std::ceil(coarse / digit) * digit;
    // Tiles are whole: with a slightly coarser spacing there may be one more.
    for (int more = 0; more < 100 && !fits(rounded); ++more)
        rounded += digit;
    return fits(rounded) ? std::optional(rounded) : std::nullopt;
}

} // namespace

Result<GridPart> fineGrid(const Setup& setup, const BoxOfInterest& box,
                          const DecimationParameters& parameters, const MapOutputs& outputs,
                          double limitBytes) {
    auto part = makeGridPart(setup.stock, box.spacing, box.box);
    if (!part)
        return part;
    const double bytesPerPoint = meshBytesPerPoint(parameters, outputs);
    const double needed = bytesOf(*part, bytesPerPoint);
    if (needed <= limitBytes)
        return part;
    const auto fits = [&](double spacing) {
        const auto other = makeGridPart(setup.stock, spacing, box.box);
        return other && bytesOf(*other, bytesPerPoint) <= limitBytes;
    };
    const auto would = finestThatFits(box, fits);
    if (!would)
        return failure(zmap_finding::kMemoryTooSmall,
                       {figures("{}", readableBytes(needed)), figures("{}", readableBytes(limitBytes))});
    return failure(detail_finding::kBoxNeedsTooMuchMemory,
                   {figures("{}", part->nx), figures("{}", part->ny), figures("{}", readableBytes(needed)),
                    figures("{}", readableBytes(limitBytes)), figures("{:g}", *would)});
}

double boxBytes(const GridPart& part, const DecimationParameters& parameters, const MapOutputs& outputs) {
    return bytesOf(part, meshBytesPerPoint(parameters, outputs));
}

DecimationParameters fineParameters(double spacing) {
    constexpr int kRegionCells = 64; // a detail region is shown as a whole, and never cut again
    DecimationParameters parameters;
    parameters.regionCells = kRegionCells;
    parameters.allowance = spacing / 2;
    return parameters;
}

std::optional<FineMap> cutBox(const Program& program, const Setup& setup, std::size_t blocks,
                              const GridPart& part, const WorkContext& context) {
    const StopWatch watch;
    const GridPart place = part.inWholeTiles();
    ZMap zmap = uncutPart(setup.stock, setup.shape, place);
    const Neighbourhood near(part, setup.stock.topZ());
    const std::size_t last = std::min(blocks, program.blockCount());
    const auto motions = cutNear(zmap, place, near, program, setup, last, context);
    if (!motions)
        return std::nullopt;
    FineMap fine;
    fine.zmap = cropped(zmap.snapshot(), static_cast<int>(part.firstI - place.firstI),
                        static_cast<int>(part.firstJ - place.firstJ), part.stock(setup.stock), part.grid());
    fine.part = part;
    fine.block = last;
    fine.motions = *motions;
    fine.seconds = watch.seconds();
    return fine;
}

bool addWalls(FineMap& fine, const std::shared_ptr<const Program>& program,
              const std::shared_ptr<const Setup>& setup, const WorkContext& context) {
    const StopWatch watch;
    Frame moment;
    moment.block = fine.block;
    moment.program = program;
    moment.setup = setup;
    moment.zmap = fine.zmap;
    ZMapSnapshot walled = RimFinder(fine.part).find(moment, context);
    if (context.stopped())
        return false;
    fine.zmap = std::move(walled);
    fine.seconds += watch.seconds();
    return true;
}

} // namespace proveout
