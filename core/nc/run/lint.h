// SPDX-License-Identifier: GPL-3.0-or-later
// What is no error and yet seldom meant. One row a rule.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/nc/state/execution.h"
#include "core/nc/state/lint_memory.h"
#include "core/nc/text/messages.h"

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
    const FindingRow* message; ///< its id names the rule
    LintMoment moment;
    void (*check)(const LintView&, const FindingRow&); ///< tells the message; null: told elsewhere
};

[[nodiscard]] std::span<const LintRule> lintRules();

/// Looks at a block that was executed.
void lintBlock(LintView view);
/// Looks at the end of the program: at the block that ends it, or at the last one where none does.
void lintEnd(const LintView& view);

} // namespace proveout
