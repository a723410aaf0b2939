// SPDX-License-Identifier: GPL-3.0-or-later
// Where the jumps, calls and parameters of a text lead, for an editor: nothing is evaluated.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/nc/text/dialect.h"
#include "core/nc/text/nc_text.h"

namespace proveout {

enum class JumpKind : std::uint8_t {
    block,       ///< GOTO 100, M97 P100
    callerBlock, ///< M99 P100: of the program that called
    program,     ///< M98 P1000, G65 P1000
    sub,         ///< o<probe> call
    construct,   ///< the other end of a loop, a branch or a subprogram
    parameter,   ///< #5, #<depth>
};

/// What a word of a line refers to. Value type.
struct JumpTarget {
    JumpKind kind = JumpKind::block;
    int number = -1;       ///< of the block or the program
    std::string name;      ///< label of a subprogram, name of a program, "#5" or "#<depth>" in lower case
    std::size_t begin = 0; ///< what names it, as indices into the line
    std::size_t end = 0;
};

/// Lines and indices are 0-based.
struct TextPlace {
    std::size_t line = 0;
    std::size_t begin = 0;
    std::size_t end = 0;

    friend bool operator==(const TextPlace&, const TextPlace&) = default;
};

/// What the word, the O-word or the parameter at index `at` of a line refers to; nothing if that is computed.
[[nodiscard]] std::optional<JumpTarget> jumpTargetAt(std::string_view line, std::size_t at,
                                                     DialectId dialect);

/// The block number to which a line jumps; nothing if there is none, or a computed one.
[[nodiscard]] std::optional<JumpTarget> blockJumpOf(std::string_view line, DialectId dialect);

/// Where a target of line `from` is in the text: of a named parameter its first assignment, of a numbered one
/// the last before that line, otherwise the first after it. Time is linear in the text.
[[nodiscard]] std::optional<TextPlace> findTarget(const NcText& text, std::size_t from,
                                                  const JumpTarget& target, DialectId dialect);

/// The names that the file of a target may have, in the folder of the program, if the text does not contain
/// it. Empty: it cannot be in a file.
[[nodiscard]] std::vector<std::string> filesOf(const JumpTarget& target, DialectId dialect);

} // namespace proveout
