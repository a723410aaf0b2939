// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/run/portions.h"

#include <algorithm>
#include <limits>

#include "core/simulation/run/checkpoints.h"

namespace proveout {

namespace {

/// Checkpoints are at most this fraction of the program apart.
constexpr std::size_t kCheckpointsOfProgram = 64;
constexpr std::size_t kFewestBlocksBetween = 16; ///< in a short program, which is cut at once anyway
/// Time of a portion without checkpoints: a stop may wait for it.
constexpr double kLongestSeconds = 0.08;
constexpr std::size_t kFirstPortion = 1; // a stop of blocks that take long loses one
/// Motions and their records are kept until the portion is done: 9 MB, and 36 MB where portions may be long,
/// because threads then wait for each other less often.
constexpr std::size_t kMostMotions = 32'768;
constexpr std::size_t kMostMotionsOfLong = 4 * kMostMotions;
/// A block with more motions, e.g. a drilling cycle, is cut alone: a stop must not lose the blocks before it.
constexpr std::size_t kMotionsOfLongBlock = 1000;

} // namespace

std::size_t checkpointBlocks(const Program& program) {
    return std::max(program.blockCount() / kCheckpointsOfProgram, kFewestBlocksBetween);
}

Portions::Portions(const Program& program, bool remembers, bool mayStop)
    : m_program(program), m_longest(remembers ? kCheckpointSeconds
                                    : mayStop ? kLongestSeconds
                                              : std::numeric_limits<double>::infinity()),
      m_largest(std::max(remembers ? checkpointBlocks(program) / 2 : program.blockCount(), kFirstPortion)),
      m_mostMotions(mayStop ? kMostMotions : kMostMotionsOfLong), m_blocks(kFirstPortion) {}

std::size_t Portions::from(std::size_t first, std::size_t end) const {
    const std::size_t most = std::min(m_blocks, end - first);
    const std::size_t begin = m_program.blockMotions(first).first;
    for (std::size_t count = 0; count < most; ++count) {
        const auto motions = m_program.blockMotions(first + count);
        if (motions.last - motions.first > kMotionsOfLongBlock || motions.last - begin > m_mostMotions)
            return std::max<std::size_t>(count, 1);
    }
    return most;
}

void Portions::took(double seconds) {
    if (seconds < m_longest / 2)
        m_blocks = std::min(2 * m_blocks, m_largest);
    else if (seconds > m_longest)
        m_blocks = std::max(m_blocks / 2, kFirstPortion);
}

} // namespace proveout
