// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/run/repetition.h"

#include <utility>

namespace proveout {

namespace {

constexpr std::size_t kCharactersOfWork = 64; ///< characters that take about as long as a line itself

std::size_t made(const Program& program) {
    return program.motionCount() + program.events().size();
}

} // namespace

void Repetition::begin(bool again, const Program& program) {
    if (again && !m_again)
        m_before = program.extent();
    m_again = again;
    m_made = made(program);
}

void Repetition::end(std::size_t length, std::optional<std::size_t> jumpedFrom, const Program& program) {
    m_jumpedFrom = jumpedFrom;
    const std::size_t more = made(program) - m_made;
    if (!m_again || more > 0)
        m_idle = 0;
    if (!m_again)
        return;
    const std::size_t work = 1 + length / kCharactersOfWork;
    m_work += work + more;
    m_idle += work;
}

Repetition::Verdict Repetition::verdict(const Limits& limits) const {
    if (m_idle > limits.idle)
        return Verdict::idle;
    return m_work > limits.work ? Verdict::tooMuch : Verdict::continues;
}

void Repetition::leftTo(std::size_t depth) {
    if (m_head && depth < m_head->depth)
        m_head.reset();
}

/// One head is kept: as long as nothing changes, it is replaced after twice as many jumps as before, so that
/// a round of any number of jumps is found (Brent's cycle detection).
bool Repetition::closes(Head head, const Program& program) {
    head.changes += m_uses;
    if (m_head == head)
        return true;
    ++m_jumps;
    if (std::exchange(m_changes, head.changes) != head.changes) {
        m_jumps = 0;
        m_nextHead = 1;
    } else if (m_head && m_jumps < m_nextHead) {
        return false;
    } else if (m_head) {
        m_nextHead = 2 * m_jumps;
    }
    m_head = head;
    m_headExtent = program.extent();
    return false;
}

} // namespace proveout
