// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/nc/text/nc_text.h"

namespace proveout {

/// The programs of a text in custom macro B's dialect, their block numbers, and which DO belongs to which
/// END. Lines are 0-based. Built in one pass; immutable.
class MacroIndex {
public:
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    explicit MacroIndex(const NcText& text);

    /// Whether the text has neither program numbers nor block numbers nor loops.
    [[nodiscard]] bool empty() const {
        return m_programs.size() == 1 && m_programs.front().number < 0 && m_programs.front().name.empty() &&
               m_labels.empty() && m_loops.empty();
    }

    /// A program from its O-word, or from the beginning of the text, to the line before the next one.
    struct Range {
        long long number = -1; ///< -1: without an O-word
        std::string name;      ///< between < and >
        std::size_t first = 0;
        std::size_t end = 0;
    };
    /// The first program with that number, or name; null if there is none.
    [[nodiscard]] const Range* program(long long number) const;
    [[nodiscard]] const Range* program(std::string_view name) const;
    [[nodiscard]] const Range& programOf(std::size_t line) const;

    /// The line with block number `number` that a jump from `line` finds: the next one in the same program,
    /// otherwise the first one from its beginning. kNone if there is none.
    [[nodiscard]] std::size_t block(long long number, std::size_t line) const;

    /// Whether the program of a line has a block number more than once.
    [[nodiscard]] bool repeated(long long number, std::size_t line) const;

    /// The END of the DO or WHILE in a line, or the DO or WHILE of the END in it; kNone if there is none.
    [[nodiscard]] std::size_t partner(std::size_t line) const;

private:
    struct Label {
        long long number;
        std::size_t line;

        // clang-tidy 14 mistakes the default for a null pointer.
        auto operator<=>(const Label&) const = default; // NOLINT(modernize-use-nullptr)
    };
    struct Loop {
        std::size_t line;
        std::size_t partner;
    };

    std::vector<Range> m_programs;
    std::unordered_map<long long, std::size_t> m_byNumber; ///< the first of each
    std::unordered_map<std::string, std::size_t> m_byName;
    std::vector<Label> m_labels; ///< by number and line
    std::vector<Loop> m_loops;   ///< by line
};

} // namespace proveout
