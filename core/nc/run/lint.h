// SPDX-License-Identifier: GPL-3.0-or-later
// Checks for what is allowed but seldom intended. One row per rule.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/nc/state/execution.h"
#include "core/nc/state/lint_memory.h"
#include "core/nc/text/messages.h"

namespace proveout {

/// When a rule is checked.
enum class LintMoment : std::uint8_t {
    block,       ///< at a block with codes
    feedWord,    ///< at a block with F
    lengths,     ///< at every block, if numbers without a point are in least increments
    arcByRadius, ///< at an arc by its radius
    firstCut,    ///< at the first feed motion of a tool
    toolWord,    ///< at a block with T
    toolChange,  ///< at M6
    end,         ///< at the end of the program
    elsewhere,   ///< reported by the part of the interpreter that notices it
};

/// What a rule examines.
struct LintView {
    const Execution& execution;
    const MachineState& before; ///< the state before the block
    LintMemory& memory;
    std::size_t firstMotion;  ///< of the block
    std::uint64_t groups = 0; ///< one bit for every modal group of which the block has a code

    [[nodiscard]] bool has(ModalGroup group) const {
        return (groups >> static_cast<unsigned>(group) & 1U) != 0;
    }
};

struct LintRule {
    const FindingRow* message; ///< its id names the rule
    LintMoment moment;
    void (*check)(const LintView&, const FindingRow&); ///< reports the message; null: reported elsewhere
};

[[nodiscard]] std::span<const LintRule> lintRules();

/// Checks a block that was executed.
void lintBlock(LintView view);
/// Checks the end of the program: the block that ends it, or the last one if none does.
void lintEnd(const LintView& view);

} // namespace proveout
