// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "core/nc/program/program.h"
#include "core/nc/text/block.h"
#include "core/nc/text/messages.h"

namespace proveout {

/// A word as messages show it: "G38.2".
[[nodiscard]] std::string nameOf(const Word& word);
/// A letter of words as written in the text.
[[nodiscard]] std::string writtenAs(char letter);

/// Passes messages to the program that is being built: the first `limit` errors and as many others, so that
/// those never displace an error, then a count. Keeps a reference to the program. The same message about the
/// same place is passed on once. Records whether any message leaves the rest unverified.
class Reporter {
public:
    using Answer = const char* (*)(const FindingRow&);

    /// `answer`: returns a remedy that replaces the one of a message, or null; may be null itself.
    Reporter(Program& program, std::string file, std::size_t limit, Answer answer = nullptr)
        : m_program(program), m_file(std::move(file)), m_limit(std::max(limit, kReserved + 1) - kReserved),
          m_answer(answer) {}

    /// For the messages that follow.
    void setFile(std::string file) { m_file = std::move(file); }
    void beginLine(std::uint32_t line) { m_line = static_cast<int>(line); }
    [[nodiscard]] std::uint32_t line() const { return static_cast<std::uint32_t>(m_line); }
    void report(const FindingRow& message, int column, int length, std::vector<Argument> arguments = {});
    void report(const FindingRow& message, const Word& word, std::vector<Argument> arguments = {}) {
        report(message, word.column, word.length, std::move(arguments));
    }
    /// Reports as a warning what would be more severe if it were not based on an assumption.
    void reportAsWarning(FindingRow message, const Word& word, std::vector<Argument> arguments) {
        message.severity = Severity::warning;
        report(message, word, std::move(arguments));
    }
    /// For a message about the whole program, reported once: shown regardless of the limit.
    void reportInAnyCase(const FindingRow& message, int column, int length,
                         std::vector<Argument> arguments = {});
    /// The last message, if there were more than the limit.
    void reportSuppressed();

    /// What it remembers of earlier messages. A value.
    struct Memory {
        std::size_t reported = 0; ///< without errors
        std::size_t errorsReported = 0;
        std::size_t suppressed = 0;
        std::size_t repeated = 0; ///< that were passed on before
        bool unverified = false;
        bool suppressedUnverified = false;
    };
    [[nodiscard]] const Memory& memory() const { return m_memory; }
    void restore(const Memory& memory) { m_memory = memory; }

    /// The number of all messages, shown or not.
    [[nodiscard]] std::size_t count() const {
        return m_memory.reported + m_memory.errorsReported + m_memory.suppressed + m_memory.repeated;
    }
    [[nodiscard]] bool unverified() const { return m_memory.unverified; }

private:
    [[nodiscard]] bool isKnown(const FindingRow& message, int column,
                               const std::vector<Argument>& arguments) const;
    void append(const FindingRow& message, bool unverified, TextRange where, std::vector<Argument> arguments);

    static constexpr std::size_t kReserved = 4; ///< slots reserved for messages about the whole program

    Program& m_program;
    std::string m_file;
    std::size_t m_limit;
    Answer m_answer;
    int m_line = 0;
    Memory m_memory;
};

} // namespace proveout
