// SPDX-License-Identifier: GPL-3.0-or-later
// What is no error and yet seldom meant. One row a rule.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <span>

#include "core/nc/execution.h"
#include "core/nc/messages.h"

namespace proveout {

/// When a rule looks.
enum class LintMoment : std::uint8_t {
    block,       ///< at a block with codes
    feedWord,    ///< at a block with F
    lengths,     ///< at every block, where numbers without a point are least units
    arcByRadius, ///< at an arc by its radius
    firstCut,    ///< at the first feed motion of a tool
    toolWord,    ///< at a block with T
    toolChange,  ///< at M6
    end,         ///< at the end of the program
    elsewhere,   ///< told by the part of the interpreter that notices it
};

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
    bool unitsTold = false;
    struct Selected {
        std::uint32_t line = 0;
        Word word;
    };
    std::map<int, Selected> missingTools; ///< by T, that the table lacks and that nothing moved yet
    std::set<std::size_t> ambiguousJumps; ///< lines whose jump has several targets, told once
    LetterSet pointTold;                  ///< letters whose numbers without a point were told
    double highestFeed =
        -std::numeric_limits<double>::infinity(); ///< Z of the ends of feed motions, since then
};

/// What a rule looks at.
struct LintView {
    const Execution& execution;
    const MachineState& before; ///< the block
    LintMemory& memory;
    std::size_t firstMotion;  ///< of the block
    std::uint64_t groups = 0; ///< a bit for every modal group that the block has a code of

    [[nodiscard]] bool has(ModalGroup group) const {
        return (groups >> static_cast<unsigned>(group) & 1U) != 0;
    }
};

struct LintRule {
    const Message* message; ///< its id names the rule
    LintMoment moment;
    void (*check)(const LintView&, const Message&); ///< tells the message; null: told elsewhere
};

[[nodiscard]] std::span<const LintRule> lintRules();

/// Looks at a block that was executed.
void lintBlock(LintView view);
/// Looks at the end of the program: at the block that ends it, or at the last one where none does.
void lintEnd(const LintView& view);

} // namespace proveout
