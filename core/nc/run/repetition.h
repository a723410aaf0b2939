// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/nc/program/program.h"

namespace proveout {

/// Notices that a program goes round without an end: by proof where nothing has changed on which the way of
/// the program depends, else by limits of what it does again. Counts and compares, and looks at no clock, so
/// that a text always ends at the same line. A value.
class Repetition {
public:
    /// Of lines that have run before.
    struct Limits {
        std::uint64_t work; ///< lines, and motions and events that they make
        std::uint64_t idle; ///< lines in a row without a motion or an event
    };

    enum class Verdict : std::uint8_t { continues, tooMuch, idle };

    /// Before a line runs: the first one again begins a repetition.
    void begin(bool again, const Program& program);
    /// After it, where it was `length` characters long. `jumpedFrom`: its line, where one
    /// comes next that is not behind it.
    void end(std::size_t length, std::optional<std::size_t> jumpedFrom, const Program& program);
    [[nodiscard]] Verdict verdict(const Limits& limits) const;
    /// The line from which the program has jumped back to the one that comes next.
    [[nodiscard]] const std::optional<std::size_t>& jumpedFrom() const { return m_jumpedFrom; }

    /// Where a program has jumped back to, and all that decides where it goes from there.
    struct Head {
        std::size_t source = 0; ///< the text
        std::size_t line = 0;
        std::size_t depth = 0;     ///< calls that are open
        std::uint64_t changes = 0; ///< of parameters and of rounds that are left, so far

        bool operator==(const Head&) const = default;
    };
    /// Whether the program was there before with nothing changed since: then it never leaves.
    [[nodiscard]] bool closes(Head head, const Program& program);
    /// Calls were left down to this depth: a head within them will not come again.
    void leftTo(std::size_t depth);
    /// The way depends on more than a head says.
    void noteUse() { ++m_uses; }

    /// The program before it began to repeat what does not end.
    [[nodiscard]] const Program::Extent& before() const { return m_before; }
    [[nodiscard]] const Program::Extent& firstRound() const { return m_headExtent; }

private:
    bool m_again = false; ///< the last line had run before
    Program::Extent m_before;
    std::size_t m_made = 0; ///< motions and events before the line
    std::uint64_t m_work = 0;
    std::uint64_t m_idle = 0;
    std::optional<std::size_t> m_jumpedFrom;

    std::optional<Head> m_head;
    Program::Extent m_headExtent;
    std::uint64_t m_uses = 0;
    std::uint64_t m_changes = 0; ///< at the last jump
    std::uint64_t m_jumps = 0;   ///< since then
    std::uint64_t m_nextHead = 1;
};

} // namespace proveout
