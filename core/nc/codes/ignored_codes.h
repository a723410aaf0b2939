// SPDX-License-Identifier: GPL-3.0-or-later
// M codes that switch a device of the machine (a clamp, a door, air) but move no axis: ignored, and listed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/diagnostic.h"

namespace proveout {

/// An M code of a program that was ignored. A value.
struct IgnoredCode {
    static constexpr std::size_t kMostLines = 8;

    const char* name = ""; ///< from the dialect's table, marked with PROVEOUT_TEXT; empty: from the user's
                           ///< list
    std::size_t count = 0; ///< the number of executions
    std::vector<std::uint32_t> lines; ///< of the main text, 1-based, each once, the first ones
    bool moreLines = false;           ///< there are more than kMostLines
    int column = 1;                   ///< in the first of these lines
    int length = 0;

    void add(std::uint32_t line, int atColumn, int ofLength);

    bool operator==(const IgnoredCode&) const = default;
};

/// By M number.
using IgnoredCodes = std::map<int, IgnoredCode>;

/// "4, 9, 15"; ends with " …" if there are more.
[[nodiscard]] std::string linesOf(const IgnoredCode& code);

inline constexpr int kLargestMCode = 99'999;

/// Reads a list such as "10, 11, M16" (separated by commas, semicolons or blanks). Error `m-code-list`: names
/// what is not a number from 0 to kLargestMCode.
[[nodiscard]] Result<std::set<int>> parseMCodes(std::string_view text);
/// "10, 11, 16".
[[nodiscard]] std::string formatMCodes(const std::set<int>& codes);

/// The M code that a message of the interpreter reports as unknown, so that it could be added to a list of
/// ignored codes; nothing for any other message.
[[nodiscard]] std::optional<int> unknownMCode(const Diagnostic& diagnostic);

} // namespace proveout
