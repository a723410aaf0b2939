// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include <glm/glm.hpp>

#include "core/nc/program/program.h"

namespace proveout {

/// One end of a toolpath line.
struct PathVertex {
    glm::vec3 position; ///< mm from PathLines::origin
    float along;        ///< mm from the start of its motion
    float kind;         ///< MotionKind
};

/// The toolpath of a range of blocks as separate lines, two vertices each.
struct PathLines {
    Vec3 origin{0};
    std::size_t firstBlock = 0;
    std::vector<PathVertex> vertices;
    std::vector<std::size_t> blockFirst; ///< first vertex of each block, then the total number of vertices

    /// The number of vertices that belong to blocks before `block` (the blocks already executed).
    [[nodiscard]] std::size_t verticesBefore(std::size_t block) const;
};

/// The most lines that are created within a frame.
inline constexpr std::size_t kMostPathLines = 400'000;

/// Lines of the blocks [firstBlock, lastBlock), clamped to the program. Arcs become chords within 0.02 mm, or
/// coarser ones if there would be more than kMostPathLines. Motions with an unknown path are skipped.
[[nodiscard]] PathLines pathLines(const Program& program, std::size_t firstBlock, std::size_t lastBlock);

/// The part of the blocks [firstBlock, lastBlock) around `block` with few enough motions for a frame; all of
/// them if the program has no more motions than that.
struct BlockRange {
    std::size_t first = 0;
    std::size_t last = 0;
};
[[nodiscard]] BlockRange blocksForFrame(const Program& program, std::size_t block, const BlockRange& wanted);

} // namespace proveout
