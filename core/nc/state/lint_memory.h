// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <set>

#include "core/nc/text/block.h"

namespace proveout {

/// What the rules remember of the blocks before. A value.
struct LintMemory {
    int toolChanges = 0;             ///< M6 that were executed
    bool lengthChosen = false;       ///< G43 and its like, since then
    bool cut = false;                ///< a feed motion, since then
    bool offsetChosen = false;       ///< G54 and its like
    bool unitsChosen = false;        ///< G20 or G21
    bool compensationBegins = false; ///< no motion since G41 or G42
    bool movedInInch = false;
    bool movedInMm = false;
    bool unitsReported = false;
    struct Selected {
        std::uint32_t line = 0;
        Word word;
    };
    std::map<int, Selected> missingTools; ///< by T, that the table lacks and that nothing moved yet
    std::set<std::size_t> ambiguousJumps; ///< lines whose jump has several targets, told once
    LetterSet pointReported;              ///< letters whose numbers without a point were told
    double highestFeed =
        -std::numeric_limits<double>::infinity(); ///< Z of the ends of feed motions, since then
};

} // namespace proveout
