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

/// Executes the blocks of a program, and what is left of those that cannot be. Keeps references to its
/// arguments.
class BlockExecutor {
public:
    BlockExecutor(const Dialect& dialect, const CodeTable& codes, const InterpretOptions& options,
                  const WorkContext& context, ControlMemory& memory, OffsetRegisters& registers,
                  IgnoredCodes& ignored, const CallStack& calls, Program& program, Reporter& reporter);

    /// Whether the block is data for the control: from G10 L50 to G11 all are.
    [[nodiscard]] bool isData(const Block& block);
    /// Takes out of a block what switches a device of the machine and moves no axis.
    void ignoreCodes(Block& block);
    /// Executes the block of a line. `request`: what it asks of the flow of the program, but for its end,
    /// which is done. Whether it has moved.
    [[nodiscard]] bool execute(const Line& line, FlowRequest& request);
    /// Whether the program is larger than the options allow, which is reported.
    [[nodiscard]] bool tooLong() const;

    /// In the place of a line that cannot be read: what it orders is not known, so the axes that it names may
    /// be anywhere afterwards. Its error is reported.
    void skip(const ReadError& error, std::string_view text);
    /// Brings saved modes back behind a call of line `line`.
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
