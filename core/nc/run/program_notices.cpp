// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/run/program_notices.h"

#include <algorithm>
#include <fmt/format.h>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/nc/motions/motion_sink.h"
#include "core/nc/text/messages.h"

namespace proveout {

namespace {

const FindingRow& ignoredMessage(bool known, bool manyLines) {
    if (known)
        return manyLines ? nc_message::kCodeIgnoredInLines : nc_message::kCodeIgnored;
    return manyLines ? nc_message::kCodeIgnoredByListInLines : nc_message::kCodeIgnoredByList;
}

} // namespace

void ProgramNotices::reportBeginning() {
    if (!m_guess.reasons.empty())
        reportGuess();
    reportListedButExecuted();
}

void ProgramNotices::reportGuess() {
    constexpr std::size_t kMostShown = 4;
    m_reporter.beginLine(1);
    std::string reasons;
    const std::span signs(m_guess.reasons);
    for (const DialectSign& sign : signs.first(std::min(signs.size(), kMostShown)))
        reasons += fmt::format("{}{} ({})", reasons.empty() ? "" : ", ", sign.shown, sign.line);
    m_reporter.report(nc_message::kDialectGuessed, 1, 0, {m_dialect.name, reasons});
}

/// Reports codes on the list of ignored ones that nevertheless have an effect.
void ProgramNotices::reportListedButExecuted() {
    constexpr int kTenths = 10;
    m_reporter.beginLine(1);
    const CodeTable& codes = codesOf(m_dialect.id);
    for (const int number : m_options.ignoredM) {
        const CodeRow* row = number < kLargestMCode / kTenths ? codes.find('M', number * kTenths) : nullptr;
        if (row != nullptr && row->handler != nullptr)
            m_reporter.report(nc_message::kIgnoredExecuted, 1, 0, {fmt::format("M{}", number), row->name});
    }
}

void ProgramNotices::reportIgnoredCodes() {
    for (const auto& [number, code] : m_run.ignored) {
        const bool known = *code.name != '\0';
        std::vector<Argument> arguments{fmt::format("M{}", number)};
        if (known)
            arguments.emplace_back(code.name);
        arguments.push_back(std::to_string(code.count));
        arguments.push_back(linesOf(code));
        m_reporter.beginLine(code.lines.front());
        m_reporter.report(ignoredMessage(known, code.lines.size() > 1), code.column, code.length,
                          std::move(arguments));
    }
}

void ProgramNotices::reportEnd(std::size_t rest) {
    const MachineState& state = m_run.memory.machine;
    const bool closed = m_run.read.percentClosed;
    if (state.compensation.on)
        m_reporter.reportInAnyCase(nc_message::kCompensationAtEnd, 1, 0);
    if (!m_run.memory.splines.nurbs.points.empty())
        m_reporter.reportInAnyCase(nc_message::kNurbsOpen, 1, 0);
    if ((state.ended || closed) && rest < m_text.lineCount()) {
        m_reporter.beginLine(static_cast<std::uint32_t>(rest + 1));
        m_reporter.reportInAnyCase(state.ended ? nc_message::kAfterEnd : nc_message::kAfterPercent, 1, 0);
    }
    if (m_program.motionCount() == 0)
        m_reporter.reportInAnyCase(nc_message::kNoMotion, 1, 0);
    else if (!state.ended && !closed)
        m_reporter.reportInAnyCase(nc_message::kNoProgramEnd, 1, 0);
    reportNeverKnown();
    if (m_options.lint)
        reportUnseen();
}

/// Reports unreachable lines, and tools that are selected but never changed to.
void ProgramNotices::reportUnseen() {
    for (const auto& [line, leaving] : m_run.unreachable.find(m_text, m_dialect.macros)) {
        m_reporter.beginLine(static_cast<std::uint32_t>(line + 1));
        m_reporter.report(nc_message::kUnreachable, 1, 0, {std::to_string(leaving + 1)});
    }
    for (const auto& [tool, selected] : m_run.memory.lint.missingTools) {
        m_reporter.beginLine(selected.line);
        m_reporter.report(nc_message::kToolNotInTable, selected.word, {std::to_string(tool)});
    }
}

/// Axes because of which a motion cut nothing have been reported there.
void ProgramNotices::reportNeverKnown() {
    const MachineState& state = m_run.memory.machine;
    const auto never = static_cast<std::uint8_t>(kAllAxes & ~(state.everKnown | state.unknownReported));
    if (never != 0 && m_program.motionCount() > 0 && !m_options.assumeStartAtZero)
        m_reporter.reportInAnyCase(nc_message::kNeverKnown, 1, 0, {namesOfAxes(never)});
}

} // namespace proveout
