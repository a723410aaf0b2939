// SPDX-License-Identifier: GPL-3.0-or-later
// The statements of custom macro B other than assignments: jumps, loops, output. Syntax only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace proveout {

enum class StatementKind : std::uint8_t {
    gotoBlock, ///< GOTO n
    ifs,       ///< IF […] GOTO n, IF […] THEN …
    whileLoop, ///< WHILE […] DO m
    doLoop,    ///< DO m
    endLoop,   ///< END m
    output,    ///< DPRNT […] and similar statements, which do not move anything
};

struct MacroStatement {
    StatementKind kind = StatementKind::gotoBlock;
    std::size_t begin = 0; ///< of its keyword, as an index into the line
    std::size_t rest = 0;  ///< index of the text after it
};

/// The statement whose keyword is at `at`; nothing if there is none.
[[nodiscard]] std::optional<MacroStatement> readStatement(std::string_view line, std::size_t at);

/// Whether a keyword is at `at`, where blanks between its letters are allowed; `at` is then moved to after
/// it.
[[nodiscard]] bool readKeyword(std::string_view line, std::size_t& at, std::string_view keyword);

} // namespace proveout
