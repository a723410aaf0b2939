// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "core/nc/codes/ignored_codes.h"
#include "core/nc/flow/call_stack.h"
#include "core/nc/program/probe_target.h"
#include "core/nc/run/interpreter.h"
#include "core/nc/state/control_memory.h"
#include "core/nc/state/execution.h"
#include "core/nc/text/lexer.h"

namespace proveout {

/// Executes the blocks of a program, and the usable remainder of those that cannot be executed. Keeps
/// references to its arguments.
class BlockExecutor {
public:
    BlockExecutor(const Dialect& dialect, const CodeTable& codes, const InterpretOptions& options,
                  const WorkContext& context, ControlMemory& memory, OffsetRegisters& registers,
                  IgnoredCodes& ignored, const CallStack& calls, Program& program, Reporter& reporter);

    /// Whether the block is data for the control: all blocks from G10 L50 to G11 are.
    [[nodiscard]] bool isData(const Block& block);
    /// Removes codes from a block that switch a device of the machine and move no axis.
    void ignoreCodes(Block& block);
    /// Executes the block of a line. `request`: what the block requests of the program flow, except its end,
    /// which is handled here. Returns whether it has moved.
    [[nodiscard]] bool execute(const Line& line, FlowRequest& request);
    /// Whether the program is larger than the options allow, which is reported.
    [[nodiscard]] bool tooLong() const;

    /// In place of a line that cannot be read: its effect is unknown, so the positions of the axes that it
    /// names are unknown afterwards. Its error is reported.
    void skip(const ReadError& error, std::string_view text);
    /// Restores saved modes after a call in line `line`.
    void restore(const MachineState& saved, std::uint32_t line);

private:
    Execution executionOf(const Block& block, FlowRequest& request);
    void endAtReturn(Execution& execution, const Word& word);

    const Dialect& m_dialect;
    const CodeTable& m_codes;
    const InterpretOptions& m_options;
    const WorkContext& m_context;
    ControlMemory& m_memory;
    OffsetRegisters& m_registers;
    IgnoredCodes& m_ignored;
    const CallStack& m_calls;
    Program& m_program;
    Reporter& m_reporter;
    const std::unique_ptr<ProbeTarget> m_target;
};

} // namespace proveout
