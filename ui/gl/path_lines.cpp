// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/path_lines.h"

#include <algorithm>
#include <cmath>

namespace proveout {
namespace {

constexpr double kChordError = 0.02;
constexpr double kCoarsest = 100; ///< mm; with a larger chord error an arc is no longer recognisable
constexpr int kMostChords = 512;
/// Before and after a block: half of a frame's limit each.
constexpr std::size_t kMostMotions = kMostPathLines / 4;

/// How arcs are split into chords.
struct Chords {
    double error = kChordError;
    int most = kMostChords;

    [[nodiscard]] int of(const Motion& motion) const {
        if (motion.kind != MotionKind::arc)
            return 1;
        const double radius = std::max(arcRadius(motion), error);
        const double angle = 2 * std::acos(std::max(1 - error / radius, 0.5));
        return std::clamp(static_cast<int>(std::ceil(std::abs(motion.sweep) / angle)), 1, most);
    }
};

/// The finest chords with which the motions stay within the limit of lines.
Chords chordsFor(const Program& program, std::size_t first, std::size_t last) {
    Chords chords;
    const auto fits = [&] {
        std::size_t lines = 0;
        for (std::size_t i = first; i < last && lines <= kMostPathLines; ++i)
            lines += static_cast<std::size_t>(chords.of(program.motion(i)));
        return lines <= kMostPathLines;
    };
    while (!fits() && chords.error < kCoarsest)
        chords.error *= 4;
    if (chords.error >= kCoarsest)
        chords.most = std::clamp(static_cast<int>(kMostPathLines / std::max<std::size_t>(last - first, 1)), 1,
                                 kMostChords);
    return chords;
}

/// The index of the first motion of a block; the number of motions if the block is after the last one.
std::size_t firstMotion(const Program& program, std::size_t block) {
    return block < program.blockCount() ? program.blockMotions(block).first : program.motionCount();
}

/// The first block of a range whose motions start at `motion` or after it; the end of the range if there is
/// none.
std::size_t blockFromMotion(const Program& program, BlockRange range, std::size_t motion) {
    while (range.first < range.last) {
        const std::size_t middle = range.first + (range.last - range.first) / 2;
        if (firstMotion(program, middle) < motion)
            range.first = middle + 1;
        else
            range.last = middle;
    }
    return range.last;
}

void append(const Motion& motion, int count, const Vec3& origin, std::vector<PathVertex>& vertices) {
    const auto kind = static_cast<float>(motion.kind);
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
    const Chords chords =
        chordsFor(program, firstMotion(program, lines.firstBlock), firstMotion(program, lastBlock));
    for (std::size_t block = lines.firstBlock; block < lastBlock; ++block) {
        lines.blockFirst.push_back(lines.vertices.size());
        const Program::MotionRange motions = program.blockMotions(block);
        for (std::size_t index = motions.first; index < motions.last; ++index)
            if (const Motion motion = program.motion(index); motion.known())
                append(motion, chords.of(motion), lines.origin, lines.vertices);
    }
    lines.blockFirst.push_back(lines.vertices.size());
    return lines;
}

BlockRange blocksForFrame(const Program& program, std::size_t block, const BlockRange& wanted) {
    const std::size_t at = firstMotion(program, block);
    const std::size_t behind = at - std::min(at, kMostMotions);
    const std::size_t ahead = at + kMostMotions;
    const BlockRange range{std::min(wanted.first, block), std::max(wanted.last, block)};
    return {blockFromMotion(program, range, behind), blockFromMotion(program, range, ahead + 1)};
}

} // namespace proveout
