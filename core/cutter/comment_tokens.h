// SPDX-License-Identifier: GPL-3.0-or-later
// Splits a comment into words and numbers. Internal to this library.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace proveout {

enum class CommentUnit : std::uint8_t { none, mm, inch, degree };

/// A word or a number of a comment, and what separates it from the one before.
struct CommentToken {
    std::string word; ///< upper case, letters only; empty for a number
    double value = 0;
    CommentUnit unit = CommentUnit::none;
    bool point = false;     ///< the number has a decimal point
    bool fraction = false;  ///< written as a fraction: 1/4, 1-1/2
    bool glued = false;     ///< a word that is not a unit follows without a blank, as in 3FL
    bool term = false;      ///< the number is a term of an expression
    bool separated = false; ///< a blank or a sign separates it from the previous token
    bool equals = false;    ///< there is a "=" or ":" in between
    bool minus = false;     ///< a minus sign directly before the number

    [[nodiscard]] bool isNumber() const { return word.empty(); }
    /// A number that may be a tool number.
    [[nodiscard]] bool isWhole() const {
        return isNumber() && !point && !fraction && unit == CommentUnit::none;
    }
};

/// The first tokens of a comment: at most 64 from its first 256 bytes. The diameter signs (Ø, ⌀, φ) become
/// the word "Ø"; a unit that follows a number belongs to it, other units are words, and variables are
/// skipped.
[[nodiscard]] std::vector<CommentToken> commentTokens(std::string_view comment);

/// The unit that a word names.
[[nodiscard]] CommentUnit unitNamed(std::string_view word);

} // namespace proveout
