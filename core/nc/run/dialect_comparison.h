// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/nc/program/program.h"

namespace proveout {

/// A line that moves the machine differently in two dialects.
struct LineDifference {
    std::uint32_t line = 0;    ///< 1-based
    std::size_t execution = 0; ///< which run of the line, from 0; lines of loops run several times
    std::vector<Motion> one;   ///< the motions of the line in each of them
    std::vector<Motion> other;
};

/// The lines at which two interpretations of one text move differently, by line: a different path, feed or
/// number of motions. At most `most` of them. Pure; any thread.
[[nodiscard]] std::vector<LineDifference> differentLines(const Program& one, const Program& other,
                                                         std::size_t most);

} // namespace proveout
