// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/nc/text/flow_word.h"
#include "core/nc/text/nc_text.h"

namespace proveout {

/// A line with an O-word, and the lines that belong to the same construct; kNone if there is none.
struct FlowLine {
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    FlowKind kind = FlowKind::programNumber;
    std::size_t line = 0;      ///< 0-based
    std::size_t next = kNone;  ///< sub, if, elseif, else, while, repeat, do: the next line of the construct
    std::size_t begin = kNone; ///< of the loop that this line is in (break, continue) or ends
    std::size_t end = kNone;   ///< of the construct
    std::size_t jump = kNone;  ///< of a repeat: the first break or continue with its label
    std::size_t twin = kNone;  ///< the line that used this label first
    bool closesDo = false;     ///< a "while" that closes a "do"
    bool nested = false;       ///< a "sub" within another one
};

/// The O-words of a text, matched by their labels. Labels of branches and loops belong to the subprogram that
/// contains them. Built in one pass; immutable.
class FlowIndex {
public:
    explicit FlowIndex(const NcText& text);

    /// Whether the text has no O-words.
    [[nodiscard]] bool empty() const { return m_rows.empty(); }
    [[nodiscard]] bool repeats() const { return m_repeats; } ///< whether it has a "repeat"
    /// The row of a line with an O-word; null for other lines and for those that could not be read.
    [[nodiscard]] const FlowLine* at(std::size_t line) const;
    /// The line "O… sub" of a label; kNone if there is none.
    [[nodiscard]] std::size_t sub(std::string_view label) const;
    /// The line that contains only the program number; kNone if there is none.
    [[nodiscard]] std::size_t program(std::string_view label) const;

private:
    std::vector<FlowLine> m_rows; ///< by line
    std::unordered_map<std::string, std::size_t> m_subs;
    std::unordered_map<std::string, std::size_t> m_programs;
    bool m_repeats = false;
};

} // namespace proveout
