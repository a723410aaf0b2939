// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/program_index.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <variant>

namespace proveout {

namespace {

constexpr double kFloorBelowCut = 5;
constexpr double kSideWithoutTool = 5; ///< margin while no cutter is known
constexpr double kSmallestSide = 5;

double largestRadius(const std::vector<int>& numbers, const ToolChoice& choice, const ToolTable& tools) {
    double radius = 0;
    for (const int number : numbers) {
        if (const Cutter* cutter = tools.find(choice.tool(number)))
            radius = std::max(radius, cutter->radius());
    }
    return radius;
}

} // namespace

std::size_t blockOfMotion(const Program& program, std::size_t motion) {
    std::size_t low = 0;
    std::size_t high = program.blockCount();
    while (low < high) {
        const std::size_t middle = (low + high) / 2;
        if (program.blockMotions(middle).last <= motion)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

std::vector<ToolChangeMark> toolChangeMarks(const Program& program) {
    std::vector<ToolChangeMark> marks;
    for (const Event& event : program.events()) {
        if (const auto* change = std::get_if<ToolChange>(&event.data))
            marks.push_back({blockOfMotion(program, event.beforeMotion), change->tool});
    }
    return marks;
}

std::optional<std::size_t> neighbouringToolChange(const Program& program, std::size_t block, int direction) {
    std::optional<std::size_t> nearest;
    for (const ToolChangeMark& mark : toolChangeMarks(program)) {
        if (direction < 0 && mark.block < block)
            nearest = mark.block;
        if (direction > 0 && mark.block > block && !nearest)
            nearest = mark.block;
    }
    return nearest;
}

CuttingExtent cuttingExtent(const Program& program) {
    std::set<int> tools;
    Box3 box;
    int newest = -1; // a tool cuts many motions in a row
    for (std::size_t i = 0; i < program.motionCount(); ++i) {
        const Motion motion = program.motion(i);
        if (motion.kind == MotionKind::rapid)
            continue;
        if (std::exchange(newest, motion.tool) != motion.tool)
            tools.insert(motion.tool);
        if (motion.known() && !motion.probing)
            box.add(bounds(motion));
    }
    return {{tools.begin(), tools.end()}, box};
}

StockBox fittedStock(const CuttingExtent& cutting, const Setup& present, const ToolChoice& choice) {
    const Box3& box = cutting.box;
    if (box.empty())
        return present.stock;
    const double radius = largestRadius(cutting.tools, choice, present.tools);
    const double margin = radius > 0 ? radius : kSideWithoutTool;
    const double top = box.lo.z < 0 ? 0 : std::ceil(box.hi.z);
    StockBox stock;
    stock.corner = {std::floor(box.lo.x - margin), std::floor(box.lo.y - margin), top};
    stock.width = std::max(kSmallestSide, std::ceil(box.hi.x + margin) - stock.corner.x);
    stock.depth = std::max(kSmallestSide, std::ceil(box.hi.y + margin) - stock.corner.y);
    stock.height = std::max(1.0, std::ceil(top - box.lo.z + kFloorBelowCut));
    return stock;
}

} // namespace proveout
