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
/// and shown quickly.
inline constexpr std::size_t kMostBlockMotions = 100'000;

struct LintMemory;
class ProbeTarget;

/// How much a program may make, and whether it has been cancelled.
struct ProgramLimits {
    std::size_t maxMotions;
    std::uint64_t maxBytes;
    const WorkContext& context;

    /// Whether a block that makes many motions has to stop before its end.
    [[nodiscard]] bool reached(const Program& program) const {
        return program.motionCount() > maxMotions || program.bytes() > maxBytes || context.stopped();
    }
};

/// The data for the handler of a code: the block, and everything that the block may change.
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
    LintMemory* lint;    ///< null: only errors are reported
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
    /// The length of 1 without a decimal point, in mm.
    [[nodiscard]] double leastLength() const {
        return state.toMm(state.inch ? dialect.leastInch : dialect.leastMm);
    }

    /// The angle that a word of the block gives, in degrees.
    [[nodiscard]] double angle(char letter) const {
        const Word& word = block.word(letter);
        return word.point ? word.value : word.value * dialect.leastMm;
    }

    /// Whether this is the number of the tool in the spindle and the tool has no sizes. The simulation
    /// reports it, which covers the empty registers with its number.
    [[nodiscard]] bool toolLacks(int number) const {
        return number == state.tool && number > 0 && tools.find(number) == nullptr;
    }

    [[nodiscard]] bool mustEnd() const { return limits.reached(program); }
    /// Whether one block may make this many motions; if not, it is reported at the word that requests them.
    /// Call it before the first one is made.
    [[nodiscard]] bool mayMake(double motions, const Word& word) const;

    /// The same control at another block, for which no lint rules are checked.
    [[nodiscard]] Execution at(const Block& other) const;
};

/// The whole number of a word; nothing, with a report, if there is none within the limits.
[[nodiscard]] std::optional<int> wholeNumber(Execution& execution, const Word& word, int least, int most);

/// Checks a block and executes it: every word at its step, each group at most once. A block that contradicts
/// itself is reported and skipped as a whole, and the positions of the axes that it names become unknown.
void executeBlock(Execution& execution);

/// Restores the modes of a saved state by executing what differs; errors are reported at `word`.
void restore(Execution& execution, const MachineState& saved, const Word& word);

} // namespace proveout
