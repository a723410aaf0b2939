// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/nc/program/program.h"

namespace proveout {

/// Detects an endless loop of a program: by proof if nothing has changed on which the flow of the program
/// depends, otherwise by limits on what is repeated. It counts and compares and does not use a clock, so that
/// a text always ends at the same line. A value.
class Repetition {
public:
    /// Limits for lines that have run before.
    struct Limits {
        std::uint64_t work; ///< lines, and motions and events that they make
        std::uint64_t idle; ///< consecutive lines without a motion or an event
    };

    enum class Verdict : std::uint8_t { continues, tooMuch, idle };

    /// Call it before a line runs: the first repeated line begins a repetition.
    void begin(bool again, const Program& program);
    /// Call it after the line, which was `length` characters long. `jumpedFrom`: its line, if the next one is
    /// not after it.
    void end(std::size_t length, std::optional<std::size_t> jumpedFrom, const Program& program);
    [[nodiscard]] Verdict verdict(const Limits& limits) const;
    /// The line from which the program has jumped back to the next one.
    [[nodiscard]] const std::optional<std::size_t>& jumpedFrom() const { return m_jumpedFrom; }

    /// The line that a program has jumped back to, and everything that determines how it continues from
    /// there.
    struct Head {
        std::size_t source = 0; ///< number of the text
        std::size_t line = 0;
        std::size_t depth = 0;     ///< number of open calls
        std::uint64_t changes = 0; ///< count of changes of parameters and of remaining rounds

        bool operator==(const Head&) const = default;
    };
    /// Whether the program was there before and nothing has changed since: then it never leaves.
    [[nodiscard]] bool closes(Head head, const Program& program);
    /// Calls have returned to this depth: a head within them will not occur again.
    void leftTo(std::size_t depth);
    /// The flow depends on more than the values of a head.
    void noteUse() { ++m_uses; }

    /// The program before the endless repetition began.
    [[nodiscard]] const Program::Extent& before() const { return m_before; }
    [[nodiscard]] const Program::Extent& firstRound() const { return m_headExtent; }

private:
    bool m_again = false; ///< whether the last line had run before
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
