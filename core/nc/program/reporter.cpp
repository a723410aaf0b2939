// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/program/reporter.h"

#include <algorithm>

#include <fmt/format.h>
#include <utility>

#include "core/base/base_findings.h"
#include "core/base/utf8.h"

namespace proveout {

namespace {

/// Bytes of an argument: names and chains of calls may be as long as the text; a message must not be.
constexpr std::size_t kLongestArgument = 2000;

void shorten(Argument& argument) {
    const std::string& text = argument.text();
    if (text.size() > kLongestArgument)
        argument = std::string(shortened(text, kLongestArgument)) + "…";
}

} // namespace

std::string nameOf(const Word& word) {
    return fmt::format("{}{:g}", writtenAs(word.letter), word.value);
}

std::string writtenAs(char letter) {
    switch (letter) {
    case kChamferLetter:
        return ",C";
    case kRoundingLetter:
        return ",R";
    case kSpindleLetter:
        return "$";
    default:
        return {letter};
    }
}

void Reporter::report(const FindingRow& message, int column, int length, std::vector<Argument> arguments) {
    std::ranges::for_each(arguments, shorten);
    m_memory.unverified = m_memory.unverified || message.unverified;
    if (isKnown(message, column, arguments)) {
        ++m_memory.repeated;
        return;
    }
    std::size_t& reported = message.severity == Severity::error ? m_memory.errorsReported : m_memory.reported;
    if (reported == m_limit) {
        ++m_memory.suppressed;
        m_memory.suppressedUnverified = m_memory.suppressedUnverified || message.unverified;
        return;
    }
    ++reported;
    append(message, message.unverified, {m_line, column, length}, std::move(arguments));
}

/// A loop reports its lines in each round.
bool Reporter::isKnown(const FindingRow& message, int column, const std::vector<Argument>& arguments) const {
    return std::ranges::any_of(m_program.diagnostics(), [&](const Diagnostic& known) {
        return known.where.line == m_line && known.where.column == column && known.id == message.id &&
               known.file == m_file && known.arguments == arguments;
    });
}

void Reporter::reportInAnyCase(const FindingRow& message, int column, int length,
                               std::vector<Argument> arguments) {
    std::ranges::for_each(arguments, shorten);
    m_memory.unverified = m_memory.unverified || message.unverified;
    append(message, message.unverified, {m_line, column, length}, std::move(arguments));
}

void Reporter::reportSuppressed() {
    if (m_memory.suppressed > 0)
        append(base_finding::kTooManyMessages, m_memory.suppressedUnverified, {m_line, 1, 0},
               {std::to_string(m_memory.suppressed)});
}

void Reporter::append(const FindingRow& message, bool unverified, TextRange where,
                      std::vector<Argument> arguments) {
    const char* const answer = m_answer == nullptr ? nullptr : m_answer(message);
    m_program.append(Diagnostic{message.severity, unverified, message.id, message.text, std::move(arguments),
                                answer == nullptr ? message.hint : answer, m_file, where});
}

} // namespace proveout
