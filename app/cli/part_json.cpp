// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/part_json.h"

#include <algorithm>
#include <cstddef>
#include <fmt/format.h>
#include <string>

namespace proveout::cli {

namespace {

using nlohmann::ordered_json;

constexpr std::size_t kIslandsPrinted = 10;

ordered_json toJson(const Vec3& place) {
    return {place.x, place.y, place.z};
}

ordered_json toJson(const ComparedIsland& island) {
    const Island& of = island.of;
    ordered_json out{{"kind", name(of.kind)},     {"depthMm", of.depthMm},     {"areaMm2", of.areaMm2},
                     {"volumeMm3", of.volumeMm3}, {"place", toJson(of.place)}, {"min", {of.lo.x, of.lo.y}},
                     {"max", {of.hi.x, of.hi.y}}};
    if (island.block)
        out.update({{"block", *island.block + 1}, {"line", island.line}, {"tool", island.tool}});
    else
        out["uncut"] = island.isUncut;
    return out;
}

ordered_json toJson(const DeviationHistogram& histogram) {
    return {{"binMm", histogram.width}, {"firstMm", histogram.middleOf(0)}, {"points", histogram.points}};
}

} // namespace

ordered_json toJson(const PartComparison& comparison) {
    const PartTolerance& tolerance = comparison.tolerance;
    const DeviationLimits& limits = comparison.deviation.limits();
    auto islands = ordered_json::array();
    for (const ComparedIsland& island : comparison.islands)
        islands.push_back(toJson(island));
    return {{"tolerance",
             {{"below", tolerance.below}, {"above", tolerance.above}, {"allowance", tolerance.allowance}}},
            {"facets", comparison.deviation.part().mesh().triangles.size()},
            {"points", comparison.judgedPoints},
            {"lowestMm", comparison.lowestMm},
            {"highestMm", comparison.highestMm},
            {"gouges", comparison.gouges},
            {"excesses", comparison.excesses},
            {"missingMm3", comparison.missingMm3},
            {"leftMm3", comparison.leftMm3},
            {"pointsWithoutSide", limits.pointsWithoutSide},
            {"unresolvedMm2", limits.unresolvedMm2},
            {"undercutMm2", limits.hiddenMm2},
            {"wallSpacingMm", limits.wallSpacing},
            {"histogram", toJson(comparison.histogram)},
            {"islands", std::move(islands)}};
}

void printPart(const ordered_json& part) {
    const ordered_json& tolerance = part["tolerance"];
    fmt::print("  part: {} gouges, {} excesses; deviations from {:.3f} to {:+.3f} mm at {} points "
               "(allowed: −{:g} to +{:g} mm)\n",
               part.value("gouges", 0), part.value("excesses", 0), part.value("lowestMm", 0.0),
               part.value("highestMm", 0.0), part.value("points", 0), tolerance.value("below", 0.0),
               tolerance.value("above", 0.0));
    const ordered_json& islands = part["islands"];
    for (std::size_t k = 0; k < std::min(islands.size(), kIslandsPrinted); ++k) {
        const ordered_json& island = islands[k];
        const std::string by = island.contains("line") ? fmt::format("line {}, T{}", island.value("line", 0),
                                                                     island.value("tool", 0))
                               : island.value("uncut", true) ? std::string("reached by no tool")
                                                             : std::string("block not determined");
        const ordered_json& place = island["place"];
        fmt::print("    {:<6} {:.3f} mm deep, {:.2f} mm², {:.2f} mm³ at X{:.3f} Y{:.3f} Z{:.3f}: {}\n",
                   island.value("kind", std::string()), island.value("depthMm", 0.0),
                   island.value("areaMm2", 0.0), island.value("volumeMm3", 0.0), place[0].get<double>(),
                   place[1].get<double>(), place[2].get<double>(), by);
    }
    if (islands.size() > kIslandsPrinted)
        fmt::print("    and {} more (--json lists them)\n", islands.size() - kIslandsPrinted);
}

} // namespace proveout::cli
