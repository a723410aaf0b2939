// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/run/dialect_comparison.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace proveout {

namespace {

constexpr double kSame = 1e-6; ///< mm, radians

/// A run of a line, and its motions [first, last).
struct Run {
    std::size_t first = 0;
    std::size_t last = 0;
};
using Key = std::pair<std::uint32_t, std::size_t>; ///< line, execution

std::map<Key, Run> runsOf(const Program& program) {
    std::map<Key, Run> runs;
    std::map<std::uint32_t, std::size_t> executions;
    for (std::size_t block = 0; block < program.blockCount(); ++block) {
        const std::uint32_t line = program.blockLine(block);
        const auto [first, last] = program.blockMotions(block);
        runs[{line, executions[line]++}] = {first, last};
    }
    return runs;
}

bool near(const Vec3& a, const Vec3& b) {
    return glm::all(glm::lessThan(glm::abs(a - b), Vec3(kSame)));
}

bool same(const Motion& a, const Motion& b) {
    if (a.kind != b.kind || !near(a.end, b.end) || std::abs(a.feedMmPerMin - b.feedMmPerMin) > kSame)
        return false;
    return a.kind != MotionKind::arc ||
           (a.plane == b.plane && near(a.centre, b.centre) && std::abs(a.sweep - b.sweep) < kSame);
}

std::vector<Motion> motionsOf(const Program& program, const Run& run) {
    std::vector<Motion> motions;
    for (std::size_t i = run.first; i < run.last; ++i)
        motions.push_back(program.motion(i));
    return motions;
}

} // namespace

std::vector<LineDifference> differentLines(const Program& one, const Program& other, std::size_t most) {
    const std::map<Key, Run> first = runsOf(one);
    std::map<Key, Run> both = runsOf(other);
    const std::map<Key, Run> second = both;
    both.insert(first.begin(), first.end());
    std::vector<LineDifference> differences;
    for (const auto& [key, run] : both) {
        if (differences.size() == most)
            break;
        const auto a = first.find(key);
        const auto b = second.find(key);
        LineDifference difference{key.first, key.second, {}, {}};
        if (a != first.end())
            difference.one = motionsOf(one, a->second);
        if (b != second.end())
            difference.other = motionsOf(other, b->second);
        if (!std::ranges::equal(difference.one, difference.other, same))
            differences.push_back(std::move(difference));
    }
    return differences;
}

} // namespace proveout
