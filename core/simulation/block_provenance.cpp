// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/block_provenance.h"

#include <algorithm>
#include <vector>

#include "core/simulation/block_cutter.h"
#include "core/simulation/tool_choice.h"

namespace proveout {

namespace {

/// Blocks that are cut at once: their motions take some 10 MB.
constexpr std::size_t kPortion = 65'536;
/// What two exact cuts may differ by: 1 µm each.
constexpr double kOnSurface = 2e-3;

/// Whether a motion may reach a place over ground with a cutter of that radius.
bool passesNear(const Motion& motion, double radius, const Vec2& place) {
    if (motion.kind == MotionKind::arc)
        return glm::distance(Vec2(motion.centre), place) <=
               radius + std::max(glm::distance(motion.centre, motion.start),
                                 glm::distance(motion.centre, motion.end));
    const auto within = [&](int axis) {
        const auto [lo, hi] = std::minmax(motion.start[axis], motion.end[axis]);
        return place[axis] >= lo - radius && place[axis] <= hi + radius;
    };
    return within(0) && within(1);
}

bool reaches(const CutterMotion& one, const Vec3& place) {
    return one.cutter != nullptr && passesNear(one.motion, one.cutter->radius(), Vec2(place)) &&
           envelope(*one.cutter, one.motion, place.x, place.y) <= place.z + kOnSurface;
}

} // namespace

std::optional<Provenance> blockProvenance(const ZMapSnapshot& uncut, const Program& program,
                                          const Setup& setup, std::size_t blocks,
                                          const WorkContext& context) {
    const ToolChoice tools(program, setup.tools);
    ZMap zmap(uncut);
    Provenance provenance(zmap);
    for (std::size_t first = 0; first < blocks; first += kPortion) {
        const std::size_t last = std::min(first + kPortion, blocks);
        const auto motions = cutterMotions(program, first, last, setup, tools);
        if (!cut(zmap, motions, context.stop, &provenance))
            return std::nullopt;
        context.tell(static_cast<double>(last) / static_cast<double>(blocks));
    }
    return provenance;
}

double provenanceBytes(const Grid& grid) {
    return zmapBytes(grid) + Provenance::bytes(grid);
}

std::optional<std::size_t> blockThatMade(const Program& program, const Setup& setup, std::size_t blocks,
                                         const Vec3& place, const std::stop_token& stop) {
    constexpr std::size_t kBetweenLooks = 1024;
    const ToolChoice tools(program, setup.tools);
    for (std::size_t first = 0; first < blocks && !stop.stop_requested(); first += kBetweenLooks) {
        const std::size_t last = std::min(first + kBetweenLooks, blocks);
        for (const CutterMotion& one : cutterMotions(program, first, last, setup, tools)) {
            if (reaches(one, place))
                return one.mark - 1;
        }
    }
    return std::nullopt;
}

} // namespace proveout
