// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/run/block_executor.h"
#include "core/nc/motions/known_axes.h"

#include <cmath>
#include <fmt/format.h>
#include <set>
#include <string>

#include "core/base/figures_argument.h"
#include "core/base/memory.h"
#include "core/base/utf8.h"
#include "core/nc/motions/compensated_path.h"
#include "core/nc/run/skipped_block.h"
#include "core/nc/text/messages.h"

namespace proveout {

namespace {

constexpr std::size_t kLongestShown = 40; ///< bytes of a line in a message

/// A part of a line for a message: limited to a readable length, cut between characters; a byte that cannot
/// be displayed is shown as its number.
std::string readable(std::string_view text) {
    if (text.size() == 1) {
        const auto byte = static_cast<unsigned char>(text.front());
        return byte < 0x20 || byte >= 0x7f ? fmt::format("\\x{:02x}", byte) : std::string(text);
    }
    return std::string(shortened(text, kLongestShown));
}

bool isIn(const std::set<int>& codes, double number) {
    return number >= 0 && number <= kLargestMCode && number == std::floor(number) &&
           codes.contains(static_cast<int>(number));
}

} // namespace

BlockExecutor::BlockExecutor(const Dialect& dialect, const CodeTable& codes, const InterpretOptions& options,
                             const WorkContext& context, ControlMemory& memory, OffsetRegisters& registers,
                             IgnoredCodes& ignored, const CallStack& calls, Program& program,
                             Reporter& reporter)
    : m_dialect(dialect), m_codes(codes), m_options(options), m_context(context), m_memory(memory),
      m_registers(registers), m_ignored(ignored), m_calls(calls), m_program(program), m_reporter(reporter),
      m_target(options.part.target()) {}

bool BlockExecutor::isData(const Block& block) {
    bool& input = m_memory.machine.dataInput;
    if (!input)
        return false;
    constexpr double kEnd = 11;
    for (const Word& word : block.codes())
        input = input && (word.letter != 'G' || word.value != kEnd);
    return true;
}

void BlockExecutor::ignoreCodes(Block& block) {
    for (std::size_t i = 0; i < block.codes().size();) {
        const Word word = block.codes()[i];
        const CodeRow* row = m_codes.find(word);
        const bool known = row != nullptr && row->ignored;
        const bool listed = row == nullptr && word.letter == 'M' && isIn(m_options.ignoredM, word.value);
        if (!known && !listed) {
            ++i;
            continue;
        }
        IgnoredCode& code = m_ignored[static_cast<int>(word.value)];
        code.name = known ? row->name : "";
        const bool here = m_calls.inMainText();
        code.add(m_calls.mainLineNumber(), here ? word.column : 1, here ? word.length : 0);
        m_memory.machine.lastM = word.value;
        block.ignoreCode(i);
    }
}

bool BlockExecutor::execute(const Line& line, FlowRequest& request) {
    Execution execution = executionOf(line.block, request);
    const std::size_t before = m_program.motionCount();
    executeBlock(execution);
    if (line.blockNumber)
        m_memory.machine.blockNumber = *line.blockNumber;
    const bool moved = m_program.motionCount() > before;
    const bool returns = request.kind == FlowRequest::Kind::returns && request.program == 0;
    if (returns && m_calls.inMainProgram()) {
        endAtReturn(execution, request.word);
        request.kind = FlowRequest::Kind::none;
    }
    return moved;
}

/// A control would restart the program; it is simulated only once.
void BlockExecutor::endAtReturn(Execution& execution, const Word& word) {
    finishCompensated(execution, word);
    m_reporter.report(nc_message::kMainReturn, word);
    m_program.append(ProgramEnd{}, m_calls.mainLineNumber());
    m_memory.machine.ended = true;
}

bool BlockExecutor::tooLong() const {
    const bool motions = m_program.motionCount() > m_options.maxMotions;
    const bool events = m_program.events().size() > m_options.maxMotions;
    const bool bytes = m_program.bytes() > m_options.maxBytes;
    if (!motions && !events && !bytes)
        return false;
    const std::string count = std::to_string(m_options.maxMotions);
    if (motions)
        m_reporter.reportInAnyCase(nc_message::kTooManyMotions, 1, 0, {count});
    else if (events)
        m_reporter.reportInAnyCase(nc_message::kTooManyEvents, 1, 0, {count});
    else
        m_reporter.reportInAnyCase(nc_message::kProgramTooLarge, 1, 0,
                                   {figures("{}", readableBytes(static_cast<double>(m_options.maxBytes)))});
    return true;
}

void BlockExecutor::skip(const ReadError& error, std::string_view text) {
    m_reporter.report(*error.message, error.column, error.length, {readable(error.argument)});
    forgetAxes(m_memory.machine, axisLetters(text), Forgotten::reported);
    if (m_dialect.streamed) // grbl drops a line that it refuses
        return;
    const ReadableWords words = readableWords(text);
    FlowRequest request;
    Execution execution = executionOf(words.block, request);
    keepModes(execution, words.codesKnown);
}

void BlockExecutor::restore(const MachineState& saved, std::uint32_t line) {
    FlowRequest none;
    const Block empty;
    Execution execution = executionOf(empty, none);
    execution.line = line; // the caller's line, if the subprogram has a separate file
    proveout::restore(execution, saved, Word{'M', 72, 1, 0});
}

Execution BlockExecutor::executionOf(const Block& block, FlowRequest& request) {
    return {m_dialect,
            m_codes,
            block,
            m_memory.machine,
            m_memory.parameters,
            m_memory.tools,
            m_registers,
            request,
            m_program,
            m_reporter,
            m_memory.saves,
            m_memory.splines,
            m_options.lint ? &m_memory.lint : nullptr,
            m_target.get(),
            {m_options.maxMotions, m_options.maxBytes, m_context},
            m_calls.depth(),
            m_calls.mainLineNumber()};
}

} // namespace proveout
