// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/program/program_index.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <variant>

namespace proveout {

namespace {

constexpr double kFloorBelowCut = 5;
constexpr double kSideWithoutTool = 5; ///< mm; margin while no cutter is known
constexpr double kSmallestSide = 5;

bool isToolChange(const Event& event) {
    return std::holds_alternative<ToolChange>(event.data);
}

double largestRadius(const std::vector<int>& numbers, const ToolChoice& choice, const ToolTable& tools) {
    double radius = 0;
    for (const int number : numbers) {
        if (const Cutter* cutter = tools.find(choice.tool(number)))
            radius = std::max(radius, cutter->radius());
    }
    return radius;
}

/// The Z of the active work offset, for motions that are queried in ascending sequence.
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

/// `cuts`: the boxes of the cuts, by the Z of the work offset.
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
    const auto count = static_cast<std::size_t>(std::ranges::count_if(program.events(), isToolChange));
    const std::size_t stretch = count > kMostMarks ? program.motionCount() / kMostMarks + 1 : 0;
    std::size_t nextMotion = 0;
    std::vector<ToolChangeMark> marks;
    for (const Event& event : program.events()) {
        const auto* change = std::get_if<ToolChange>(&event.data);
        if (change == nullptr || event.beforeMotion < nextMotion)
            continue;
        marks.push_back({blockOfMotion(program, event.beforeMotion), change->tool});
        nextMotion = stretch == 0 ? 0 : event.beforeMotion + stretch;
    }
    return marks;
}

std::optional<std::size_t> neighbouringToolChange(const Program& program, std::size_t block, int direction) {
    const std::vector<Event>& events = program.events();
    const auto blockOf = [&](const Event& event) { return blockOfMotion(program, event.beforeMotion); };
    if (direction > 0) {
        const auto behind = std::ranges::upper_bound(events, block, {}, blockOf);
        const auto found = std::find_if(behind, events.end(), isToolChange);
        return found == events.end() ? std::nullopt : std::optional(blockOf(*found));
    }
    const auto before = std::make_reverse_iterator(std::ranges::lower_bound(events, block, {}, blockOf));
    const auto found = std::find_if(before, events.rend(), isToolChange);
    return found == events.rend() ? std::nullopt : std::optional(blockOf(*found));
}

CuttingExtent cuttingExtent(const Program& program) {
    std::set<int> tools;
    Box3 box;
    WorkZero zero(program);
    std::map<double, Box3> cuts;
    int newest = -1; // avoids a lookup per motion, because a tool cuts many motions in a row
    for (std::size_t i = 0; i < program.motionCount(); ++i) {
        const Motion motion = program.motion(i);
        if (motion.kind == MotionKind::rapid)
            continue;
        if (std::exchange(newest, motion.tool) != motion.tool)
            tools.insert(motion.tool);
        if (motion.known() && !motion.probing) {
            const Box3 reach = bounds(motion);
            box.add(reach);
            cuts[zero.at(i)].add(reach);
        }
    }
    return {{tools.begin(), tools.end()}, box, topOf(cuts)};
}

StockBox fittedStock(const CuttingExtent& cutting, const Setup& present, const ToolChoice& choice) {
    const Box3& box = cutting.box;
    if (box.empty())
        return present.stock;
    const double radius = largestRadius(cutting.tools, choice, present.tools);
    const double margin = radius > 0 ? radius : kSideWithoutTool;
    StockBox stock;
    stock.corner = {std::floor(box.lo.x - margin), std::floor(box.lo.y - margin), cutting.top};
    stock.width = std::max(kSmallestSide, std::ceil(box.hi.x + margin) - stock.corner.x);
    stock.depth = std::max(kSmallestSide, std::ceil(box.hi.y + margin) - stock.corner.y);
    stock.height = std::max(1.0, std::ceil(cutting.top - box.lo.z + kFloorBelowCut));
    return stock;
}

} // namespace proveout
