// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core/nc/program/program.h"

namespace proveout {

/// The blocks between two checkpoints, at most: even cheap blocks add up when all of them are executed, and
/// an edit should cut little more than what follows it.
[[nodiscard]] std::size_t checkpointBlocks(const Program& program);

/// How many blocks are cut at once when they are not shown one by one: they share the start-up work, and a
/// stop loses one portion at most. Owned by one thread; `program` must outlive it.
class Portions {
public:
    /// `remembers`: there are checkpoints, which are made between two portions. `mayStop`: a caller may wait
    /// for the end of a portion.
    Portions(const Program& program, bool remembers, bool mayStop);

    /// The number of blocks to cut next, from block `first` on, which is before block `end`.
    [[nodiscard]] std::size_t from(std::size_t first, std::size_t end) const;
    /// The last portion took that long.
    void took(double seconds);

private:
    const Program& m_program;
    double m_longest; ///< seconds of a portion
    std::size_t m_largest;
    std::size_t m_mostMotions;
    std::size_t m_blocks;
};

} // namespace proveout
