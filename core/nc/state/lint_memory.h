// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <set>

#include "core/nc/text/block.h"

namespace proveout {

/// What the rules remember of earlier blocks. A value.
struct LintMemory {
    int toolChanges = 0;             ///< M6 that were executed
    bool lengthChosen = false;       ///< G43 and similar codes, since then
    bool cut = false;                ///< a feed motion, since then
    bool offsetChosen = false;       ///< G54 and similar codes
    bool unitsChosen = false;        ///< G20 or G21
    bool compensationBegins = false; ///< no motion since G41 or G42
    bool movedInInch = false;
    bool movedInMm = false;
    bool unitsReported = false;
    struct Selected {
        std::uint32_t line = 0;
        Word word;
    };
    std::map<int, Selected> missingTools; ///< by T, that are not in the table and have not moved yet
    std::set<std::size_t> ambiguousJumps; ///< lines whose jump has several targets, reported once
    LetterSet pointReported;              ///< letters whose numbers without a point have been reported
    double highestFeed =
        -std::numeric_limits<double>::infinity(); ///< Z of the ends of feed motions, since then
};

} // namespace proveout
