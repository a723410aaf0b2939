// SPDX-License-Identifier: GPL-3.0-or-later
// The statements of custom macro B that are no assignments: jumps, loops, output. Syntax only.
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
    output,    ///< DPRNT […] and its like: nothing that moves
};

struct MacroStatement {
    StatementKind kind = StatementKind::gotoBlock;
    std::size_t begin = 0; ///< of its keyword, as an index into the line
    std::size_t rest = 0;  ///< what follows it
};

/// The statement whose keyword stands at `at`; nothing where none does.
[[nodiscard]] std::optional<MacroStatement> readStatement(std::string_view line, std::size_t at);

/// Whether a word of letters stands at `at`, blanks between them allowed; `at` then points behind it.
[[nodiscard]] bool readKeyword(std::string_view line, std::size_t& at, std::string_view keyword);

} // namespace proveout
