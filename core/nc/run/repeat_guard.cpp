// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/run/repeat_guard.h"

#include <optional>
#include <string>

#include "core/nc/text/messages.h"

namespace proveout {

bool RepeatGuard::mayRun() {
    return !repeatsTooMuch() && !goesRoundForGood();
}

/// Loops and calls have limits, so that every program ends in reasonable time.
bool RepeatGuard::repeatsTooMuch() {
    const Repetition& repetition = m_state.repetition;
    const Repetition::Verdict verdict = repetition.verdict(m_limits);
    if (verdict == Repetition::Verdict::continues)
        return false;
    const bool idle = verdict == Repetition::Verdict::idle;
    m_program.cutBack(repetition.before());
    m_reporter.reportInAnyCase(
        idle ? nc_message::kIdleLoop : nc_message::kTooMuchRepeated, 1, 0,
        {std::to_string(idle ? m_limits.idle : m_limits.work), m_calls.linesOfCalls()});
    return true;
}

/// Whether it is proved that the program never leaves the loop of this line.
bool RepeatGuard::goesRoundForGood() {
    Repetition& repetition = m_state.repetition;
    const auto from = repetition.jumpedFrom();
    if (!from)
        return false;
    const Repetition::Head head{m_calls.source().number, m_calls.at(), m_calls.depth(),
                                m_parameters.changes() + m_calls.roundsCounted()};
    if (!repetition.closes(head, m_program))
        return false;
    m_program.cutBack(repetition.firstRound());
    m_reporter.reportInAnyCase(nc_message::kEndlessLoop, 1, 0,
                               {std::to_string(*from + 1), std::to_string(m_calls.at() + 1)});
    return true;
}

RepeatGuard::Started RepeatGuard::begin(std::size_t linesRead) {
    m_state.repetition.begin(m_calls.isAgain(), m_program);
    const bool again = m_calls.at() < linesRead;
    m_state.runsAgain = m_state.runsAgain || again;
    return {again, m_calls.at(), m_calls.currentText().size(), m_reporter.count()};
}

void RepeatGuard::end(const Started& line, bool depends) {
    const bool reported = m_reporter.count() > line.reported;
    m_state.reportedAgain += line.again && reported ? 1 : 0;
    Repetition& repetition = m_state.repetition;
    // A line that reports something for the first time may behave differently the next time.
    if (depends || reported)
        repetition.noteUse();
    repetition.leftTo(m_calls.resetLowestDepth());
    repetition.end(line.length, m_calls.line() <= line.at ? std::optional(line.at) : std::nullopt, m_program);
}

/// A loop whose condition never changes, because one of its lines cannot be read, must not run to the limit.
bool RepeatGuard::reportsTooOften() const {
    constexpr std::size_t kMostAgain = 10'000;
    if (m_state.reportedAgain < kMostAgain)
        return false;
    m_reporter.reportInAnyCase(nc_message::kTooManyAgain, 1, 0, {std::to_string(kMostAgain)});
    return true;
}

} // namespace proveout
