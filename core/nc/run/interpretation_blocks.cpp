// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <fmt/format.h>
#include <set>

#include "core/base/memory.h"
#include "core/nc/motions/compensated_path.h"
#include "core/nc/run/interpretation.h"

namespace proveout {

namespace {

bool isIn(const std::set<int>& codes, double number) {
    return number >= 0 && number <= kLargestMCode && number == std::floor(number) &&
           codes.contains(static_cast<int>(number));
}

} // namespace

void Interpretation::runBlock(bool first) {
    m_run.sourceBlocks += first ? 1 : 0;
    if (isData())
        return;
    ignoreCodes();
    assign();
    if (m_line.block.empty())
        return;
    FlowRequest request;
    Execution execution = executionOf(m_line.block, request);
    const std::size_t before = m_program->motionCount();
    executeBlock(execution);
    if (m_line.blockNumber)
        m_state.blockNumber = *m_line.blockNumber;
    const bool moved = m_program->motionCount() > before;
    checkPlaceOfCall(request);
    const bool returns = request.kind == FlowRequest::Kind::returns && request.program == 0;
    if (request.kind == FlowRequest::Kind::returns && !m_calls.inMainProgram())
        noteLeaving();
    if (returns && m_calls.inMainProgram())
        endAtReturn(execution, request.word);
    else if (request.kind != FlowRequest::Kind::none)
        carryOut([&] { return runRequest(request); });
    if (moved && m_macroB && !m_macros.afterMotion())
        m_state.forget(LetterSet("XYZ"), Forgotten::reported);
    m_finished = m_state.ended || tooLong();
}

/// Takes out of the block what switches a device of the machine and moves no axis.
void Interpretation::ignoreCodes() {
    Block& block = m_line.block;
    for (std::size_t i = 0; i < block.codes().size();) {
        const Word word = block.codes()[i];
        const CodeRow* row = m_codes.find(word);
        const bool known = row != nullptr && row->ignored;
        const bool listed = row == nullptr && word.letter == 'M' && isIn(m_options.ignoredM, word.value);
        if (!known && !listed) {
            ++i;
            continue;
        }
        IgnoredCode& code = m_run.ignored[static_cast<int>(word.value)];
        code.name = known ? row->name : "";
        const bool here = m_calls.inMainText();
        code.add(mainLine(), here ? word.column : 1, here ? word.length : 0);
        m_state.lastM = word.value;
        block.ignoreCode(i);
    }
}

/// From G10 L50 to G11 the blocks are data for the control.
bool Interpretation::isData() {
    if (!m_state.dataInput)
        return false;
    constexpr double kEnd = 11;
    for (const Word& word : m_line.block.codes())
        m_state.dataInput = m_state.dataInput && (word.letter != 'G' || word.value != kEnd);
    return true;
}

/// LinuxCNC finds M98 at the beginning of a block only, and M99 alone in it; but M99 of the main program,
/// where it likes.
void Interpretation::checkPlaceOfCall(const FlowRequest& request) {
    if (m_dialect.macros != MacroLanguage::oWords)
        return;
    const Place& late = m_line.lateCall;
    if (request.kind == FlowRequest::Kind::call && late.column > 0)
        m_reporter.tell(nc_message::kCallNotFirst, late.column, late.length, {"M98"});
    const bool alone = late.column == 0 && m_line.block.letters().empty() && m_line.block.codes().size() == 1;
    if (request.kind == FlowRequest::Kind::returns && !m_calls.inMainProgram() && !alone)
        m_reporter.tell(nc_message::kReturnNotAlone, request.word);
}

/// A control would start the program again; once is what there is to see.
void Interpretation::endAtReturn(Execution& execution, const Word& word) {
    finishCompensated(execution, word);
    m_reporter.tell(nc_message::kMainReturn, word);
    m_program->append(ProgramEnd{}, mainLine());
    m_state.ended = true;
}

void Interpretation::assign() {
    for (const Assignment& order : m_line.assignments) {
        const std::string& name = order.target.name;
        if (m_macroB && writeVariable(order))
            continue;
        if (m_dialect.macros == MacroLanguage::oWords && name.empty() &&
            order.target.number == kInputParameter)
            m_state.inputAssumed = false;
        if (m_dialect.macros == MacroLanguage::oWords && name.empty() &&
            order.target.number == kActiveOffset) {
            m_state.writtenOffset = order.value;
            m_reporter.tell(nc_message::kOffsetNumberWritten, order.column, order.length);
            continue;
        }
        const bool readOnly = name.empty() ? m_system.numbered(order.target.number).has_value()
                                           : m_system.named(name).has_value();
        const std::string shown =
            name.empty() ? fmt::format("#{}", order.target.number) : fmt::format("#<{}>", name);
        if (readOnly)
            m_reporter.tell(nc_message::kParameterReadOnly, order.column, order.length, {shown});
        else if (name.empty())
            m_parameters.setNumbered(order.target.number, order.value);
        else if (!m_parameters.setNamed(name, order.value))
            m_reporter.tell(nc_message::kNamesTooMany, order.column, order.length, {shown});
    }
    (void)m_system.takeProbeRead(); // writing it is no use of it
}

/// What writing a system variable of custom macro B does besides; true where it is stored nowhere.
bool Interpretation::writeVariable(const Assignment& order) {
    const std::string shown = fmt::format("#{}", order.target.number);
    switch (m_variables.writing(order.target.number)) {
    case MacroVariables::Writing::stored: {
        const int number = m_variables.storedAs(order.target.number);
        m_parameters.setNumbered(number, order.value);
        return number != order.target.number;
    }
    case MacroVariables::Writing::ignored:
        return true;
    case MacroVariables::Writing::offset:
        m_variables.write(order.target.number, isNull(order.value) ? 0 : order.value, *m_program, mainLine());
        return true;
    case MacroVariables::Writing::readOnly:
        m_reporter.tell(nc_message::kParameterReadOnly, order.column, order.length, {shown});
        return true;
    case MacroVariables::Writing::alarm:
        m_reporter.tell(nc_message::kAlarm, order.column, order.length, {fmt::format("{:g}", order.value)});
        m_state.ended = m_finished = true;
        return true;
    case MacroVariables::Writing::stop:
        m_program->append(ProgramStop{StopKind::program}, mainLine());
        return true;
    }
    return true;
}

bool Interpretation::tooLong() {
    const bool motions = m_program->motionCount() > m_options.maxMotions;
    const bool events = m_program->events().size() > m_options.maxMotions;
    const bool bytes = m_program->bytes() > m_options.maxBytes;
    if (!motions && !events && !bytes)
        return false;
    const std::string count = std::to_string(m_options.maxMotions);
    if (motions)
        m_reporter.tellInAnyCase(nc_message::kTooManyMotions, 1, 0, {count});
    else if (events)
        m_reporter.tellInAnyCase(nc_message::kTooManyEvents, 1, 0, {count});
    else
        m_reporter.tellInAnyCase(nc_message::kProgramTooLarge, 1, 0,
                                 {readableBytes(static_cast<double>(m_options.maxBytes))});
    m_cutShort = true;
    return true;
}

Execution Interpretation::executionOf(const Block& block, FlowRequest& request) {
    return {m_dialect,
            m_codes,
            block,
            m_state,
            m_parameters,
            m_run.tools,
            m_registers,
            request,
            *m_program,
            m_reporter,
            m_run.saves,
            m_run.splines,
            m_options.lint ? &m_run.lint : nullptr,
            m_target.get(),
            m_calls.depth(),
            mainLine(),
            m_options.maxMotions,
            m_options.maxBytes,
            m_context};
}

} // namespace proveout
