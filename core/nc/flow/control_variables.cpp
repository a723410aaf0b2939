// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/flow/control_variables.h"

#include <fmt/format.h>
#include <string>

#include "core/nc/state/probing.h"
#include "core/nc/text/messages.h"

namespace proveout {

ControlVariables::ControlVariables(const Dialect& dialect, bool blockDelete, ControlMemory& memory,
                                   std::set<int>& assumedReported, Program& program, Reporter& reporter)
    : m_dialect(dialect), m_state(memory.machine), m_parameters(memory.parameters),
      m_assumedReported(assumedReported), m_program(program), m_reporter(reporter),
      m_registers(memory.tools, dialect.registersHoldDiameter), m_machine(m_state),
      m_macroB(m_state, m_parameters, m_registers, dialect), m_offsets(m_state),
      m_system(systemValues()), m_context{m_parameters, m_system, dialect, blockDelete} {}

const SystemValues& ControlVariables::systemValues() const {
    switch (m_dialect.macros) {
    case MacroLanguage::macroB:
        return m_macroB;
    case MacroLanguage::labels:
    case MacroLanguage::none:
        return m_offsets;
    case MacroLanguage::oWords:
        break;
    }
    return m_machine;
}

void ControlVariables::assign(std::span<const Assignment> assignments, std::uint32_t line) {
    for (const Assignment& order : assignments)
        assign(order, line);
    (void)m_system.consumeProbeRead(); // writing it does not count as use
}

void ControlVariables::assign(const Assignment& order, std::uint32_t line) {
    const std::string& name = order.target.name;
    if (m_dialect.macros == MacroLanguage::macroB && writeVariable(order, line))
        return;
    if (m_dialect.macros == MacroLanguage::oWords && name.empty() && assignInput(order))
        return;
    const bool readOnly =
        name.empty() ? m_system.numbered(order.target.number).has_value() : m_system.named(name).has_value();
    const std::string shown =
        name.empty() ? fmt::format("#{}", order.target.number) : fmt::format("#<{}>", name);
    if (readOnly)
        m_reporter.report(nc_message::kParameterReadOnly, order.column, order.length, {shown});
    else if (name.empty())
        m_parameters.setNumbered(order.target.number, order.value);
    else if (!m_parameters.setNamed(name, order.value))
        m_reporter.report(nc_message::kNamesTooMany, order.column, order.length, {shown});
}

/// Further effects of writing a parameter of LinuxCNC; true if the caller must not store it.
bool ControlVariables::assignInput(const Assignment& order) {
    if (order.target.number == kInputParameter)
        m_state.inputAssumed = false;
    if (order.target.number != kActiveOffset)
        return false;
    m_state.writtenOffset = order.value;
    m_reporter.report(nc_message::kOffsetNumberWritten, order.column, order.length);
    return true;
}

/// Further effects of writing a system variable of custom macro B; true if the caller must not store it.
bool ControlVariables::writeVariable(const Assignment& order, std::uint32_t line) {
    const std::string shown = fmt::format("#{}", order.target.number);
    switch (m_macroB.writing(order.target.number)) {
    case MacroVariables::Writing::stored: {
        const int number = m_macroB.storedAs(order.target.number);
        m_parameters.setNumbered(number, order.value);
        return number != order.target.number;
    }
    case MacroVariables::Writing::ignored:
        return true;
    case MacroVariables::Writing::offset:
        m_macroB.write(order.target.number, isNull(order.value) ? 0 : order.value, m_program, line);
        return true;
    case MacroVariables::Writing::readOnly:
        m_reporter.report(nc_message::kParameterReadOnly, order.column, order.length, {shown});
        return true;
    case MacroVariables::Writing::alarm:
        m_reporter.report(nc_message::kAlarm, order.column, order.length, {fmt::format("{:g}", order.value)});
        m_state.ended = true;
        return true;
    case MacroVariables::Writing::stop:
        m_program.append(ProgramStop{StopKind::program}, line);
        return true;
    }
    return true;
}

void ControlVariables::reportReads() {
    if (m_system.consumeProbeRead())
        reportProbeUse(m_state, m_reporter);
    if (const int number = m_system.consumeAssumedRead();
        number != 0 && m_assumedReported.insert(number).second)
        m_reporter.report(nc_message::kVariableAssumed, 1, 0, {fmt::format("#{}", number)});
    if (!m_machine.consumeInputRead() || !m_state.inputAssumed)
        return;
    m_state.inputAssumed = false;
    m_reporter.report(nc_message::kInputUsed, 1, 0);
}

void ControlVariables::forgetReads() {
    (void)m_machine.consumeInputRead();
    (void)m_system.consumeProbeRead();
}

} // namespace proveout
