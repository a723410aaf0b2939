// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include <glm/glm.hpp>

#include "core/nc/program/program.h"

namespace proveout {

/// An end of a drawn line of the toolpath.
struct PathVertex {
    glm::vec3 position; ///< mm from PathLines::origin
    float along;        ///< mm from the start of its motion
    float kind;         ///< MotionKind
};

/// The toolpath of a run of blocks as separate lines, two vertices each.
struct PathLines {
    Vec3 origin{0};
    std::size_t firstBlock = 0;
    std::vector<PathVertex> vertices;
    std::vector<std::size_t> blockFirst; ///< first vertex of each block, then one past the last

    /// How many vertices belong to blocks before `block` (blocks executed so far).
    [[nodiscard]] std::size_t verticesBefore(std::size_t block) const;
};

/// So many lines are made within a frame.
inline constexpr std::size_t kMostPathLines = 400'000;

/// Lines of the blocks [firstBlock, lastBlock), clamped to the program. Arcs become chords within 0.02 mm, or
/// coarser where those are more than kMostPathLines. Motions whose path is not known are left out.
[[nodiscard]] PathLines pathLines(const Program& program, std::size_t firstBlock, std::size_t lastBlock);

/// Of the blocks [firstBlock, lastBlock) those about `block` that have few enough motions for a frame; all
/// where the program has no more of them.
struct BlockRange {
    std::size_t first = 0;
    std::size_t last = 0;
};
[[nodiscard]] BlockRange blocksForFrame(const Program& program, std::size_t block, const BlockRange& wanted);

} // namespace proveout
