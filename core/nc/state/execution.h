// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/base/work_context.h"
#include "core/nc/codes/codes.h"
#include "core/nc/program/program.h"
#include "core/nc/program/reporter.h"
#include "core/nc/state/flow_request.h"
#include "core/nc/state/machine_state.h"
#include "core/nc/state/modal_saves.h"
#include "core/nc/state/offset_registers.h"
#include "core/nc/state/spline_state.h"
#include "core/nc/state/tool_offsets.h"
#include "core/nc/text/block.h"
#include "core/nc/text/dialect.h"
#include "core/nc/text/parameters.h"

namespace proveout {

/// The limit of the motions of one block: far more than a machine runs from one, and few enough to be made
/// and shown in a moment.
inline constexpr std::size_t kMostBlockMotions = 100'000;

struct LintMemory;
class ProbeTarget;

/// How much a program may make, and whether it is still wanted.
struct ProgramLimits {
    std::size_t maxMotions;
    std::uint64_t maxBytes;
    const WorkContext& context;

    /// Whether a block that makes many motions has to stop in between.
    [[nodiscard]] bool reached(const Program& program) const {
        return program.motionCount() > maxMotions || program.bytes() > maxBytes || context.stopped();
    }
};

/// What the handler of a code works on: the block, and everything that the block may change.
struct Execution {
    const Dialect& dialect;
    const CodeTable& codes;
    const Block& block;
    MachineState& state;
    Parameters& parameters;
    ToolOffsets& tools;
    OffsetRegisters& registers;
    FlowRequest& request;
    Program& program;
    Reporter& reporter;
    ModalSaves& saves;
    SplineState& splines;
    LintMemory* lint;    ///< null: nothing is told that is no error
    ProbeTarget* target; ///< of probing motions; null: there is none
    ProgramLimits limits;
    std::size_t callLevel;                 ///< 0: the main program
    std::uint32_t line;                    ///< source line, 1-based
    bool machineCoordinates = false;       ///< G53: of this block's axis words
    const CodeRow* motionBefore = nullptr; ///< the motion code in force before this block

    /// The length that a word of the block gives, in mm.
    [[nodiscard]] double length(char letter) const {
        const Word& word = block.word(letter);
        return word.point ? state.toMm(word.value) : word.value * leastLength();
    }
    /// What 1 without a decimal point is as a length, in mm.
    [[nodiscard]] double leastLength() const {
        return state.toMm(state.inch ? dialect.leastInch : dialect.leastMm);
    }

    /// The angle that a word of the block gives, in degrees.
    [[nodiscard]] double angle(char letter) const {
        const Word& word = block.word(letter);
        return word.point ? word.value : word.value * dialect.leastMm;
    }

    /// Whether the tool in the spindle has this number and no sizes. The simulation reports it; that the
    /// registers with its number are empty is part of that.
    [[nodiscard]] bool toolLacks(int number) const {
        return number == state.tool && number > 0 && tools.find(number) == nullptr;
    }

    [[nodiscard]] bool mustEnd() const { return limits.reached(program); }
    /// Whether one block may make so many motions; told at the word that asks for them where not. Asked
    /// before the first one is made.
    [[nodiscard]] bool mayMake(double motions, const Word& word) const;

    /// The same control at another block, about which no rule is asked.
    [[nodiscard]] Execution at(const Block& other) const;
};

/// The whole number of a word, told where it is none within the limits.
[[nodiscard]] std::optional<int> wholeNumber(Execution& execution, const Word& word, int least, int most);

/// Checks a block and executes it: every word at its step, each group at most once. A block that contradicts
/// itself is told and skipped whole, and the axes that it names are forgotten.
void executeBlock(Execution& execution);

/// Brings the modes of a saved state back by executing what differs; what goes wrong is told at `word`.
void restore(Execution& execution, const MachineState& saved, const Word& word);

} // namespace proveout
