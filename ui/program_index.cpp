// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/program_index.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <variant>

#include "core/simulation/tool_choice.h"

namespace proveout {

namespace {

constexpr double kFloorBelowCut = 5;
constexpr double kSideWithoutTool = 5; ///< margin while no cutter is known
constexpr double kSmallestSide = 5;

double largestRadius(const std::vector<int>& numbers, const ToolTable& tools) {
    double radius = 0;
    for (const int number : numbers) {
        if (const Cutter* cutter = tools.find(number))
            radius = std::max(radius, cutter->radius());
    }
    return radius;
}

/// The Z of the work offset in force, for motions asked about in their order.
class WorkZero {
public:
    explicit WorkZero(const Program& program) : m_events(&program.events()) {}
    double at(std::size_t motion) {
        for (; m_next < m_events->size() && (*m_events)[m_next].beforeMotion <= motion; ++m_next) {
            if (const auto* offset = std::get_if<WorkOffset>(&(*m_events)[m_next].data))
                m_z = offset->offset.z;
        }
        return m_z;
    }

private:
    const std::vector<Event>* m_events;
    std::size_t m_next = 0;
    double m_z = 0;
};

/// `cuts`: what is cut, by the Z of the work offset.
double topOf(const std::map<double, Box3>& cuts) {
    std::optional<double> highest;
    for (const auto& [zero, box] : cuts) {
        const double top = box.lo.z < zero ? zero : std::ceil(box.hi.z);
        highest = std::max(highest.value_or(top), top);
    }
    return highest.value_or(0);
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
    WorkZero zero(program);
    std::map<double, Box3> cuts;
    int newest = -1; // a tool cuts many motions in a row
    const std::size_t firstCalled = firstMotionWithCalledTool(program);
    for (std::size_t i = 0; i < program.motionCount(); ++i) {
        const Motion motion = program.motion(i);
        if (motion.kind == MotionKind::rapid)
            continue;
        const bool called = motion.tool > 0 || i >= firstCalled;
        if (called && std::exchange(newest, motion.tool) != motion.tool)
            tools.insert(motion.tool);
        if (motion.known() && !motion.probing) {
            const Box3 reach = bounds(motion);
            box.add(reach);
            cuts[zero.at(i)].add(reach);
        }
    }
    return {{tools.begin(), tools.end()}, box, topOf(cuts)};
}

StockBox fittedStock(const CuttingExtent& cutting, const Setup& present) {
    const Box3& box = cutting.box;
    if (box.empty())
        return present.stock;
    const double radius = largestRadius(cutting.tools, present.tools);
    const double margin = radius > 0 ? radius : kSideWithoutTool;
    StockBox stock;
    stock.corner = {std::floor(box.lo.x - margin), std::floor(box.lo.y - margin), cutting.top};
    stock.width = std::max(kSmallestSide, std::ceil(box.hi.x + margin) - stock.corner.x);
    stock.depth = std::max(kSmallestSide, std::ceil(box.hi.y + margin) - stock.corner.y);
    stock.height = std::max(1.0, std::ceil(cutting.top - box.lo.z + kFloorBelowCut));
    return stock;
}

} // namespace proveout
