// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/path_lines.h"

#include <algorithm>
#include <cmath>

namespace proveout {
namespace {

constexpr double kChordError = 0.02;
constexpr int kMostChords = 512;

int chords(const Motion& motion) {
    if (motion.kind != MotionKind::arc)
        return 1;
    const double radius = std::max(arcRadius(motion), kChordError);
    const double angle = 2 * std::acos(std::max(1 - kChordError / radius, 0.5));
    return std::clamp(static_cast<int>(std::ceil(std::abs(motion.sweep) / angle)), 1, kMostChords);
}

void append(const Motion& motion, const Vec3& origin, std::vector<PathVertex>& vertices) {
    const auto kind = static_cast<float>(motion.kind);
    const int count = chords(motion);
    Vec3 from = motion.start;
    double along = 0;
    for (int k = 1; k <= count; ++k) {
        const Vec3 to = pointAt(motion, static_cast<double>(k) / count);
        const double length = glm::distance(from, to);
        vertices.push_back({glm::vec3(from - origin), static_cast<float>(along), kind});
        along += length;
        vertices.push_back({glm::vec3(to - origin), static_cast<float>(along), kind});
        from = to;
    }
}

} // namespace

std::size_t PathLines::verticesBefore(std::size_t block) const {
    if (blockFirst.empty() || block <= firstBlock)
        return 0;
    return blockFirst[std::min(block - firstBlock, blockFirst.size() - 1)];
}

PathLines pathLines(const Program& program, std::size_t firstBlock, std::size_t lastBlock) {
    PathLines lines;
    lastBlock = std::min(lastBlock, program.blockCount());
    lines.firstBlock = std::min(firstBlock, lastBlock);
    if (!program.bounds().empty())
        lines.origin = program.bounds().lo;
    for (std::size_t block = lines.firstBlock; block < lastBlock; ++block) {
        lines.blockFirst.push_back(lines.vertices.size());
        const Program::MotionRange motions = program.blockMotions(block);
        for (std::size_t index = motions.first; index < motions.last; ++index)
            if (const Motion motion = program.motion(index); motion.known())
                append(motion, lines.origin, lines.vertices);
    }
    lines.blockFirst.push_back(lines.vertices.size());
    return lines;
}

} // namespace proveout
