// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of words by which comments name tools and their sizes. Internal to this library.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/cutter/comment_tokens.h"

namespace proveout {

/// What the number after a label is.
enum class CommentField : std::uint8_t {
    toolNumber,
    diameter,     ///< of anything that the comment is about
    toolDiameter, ///< of a tool, whatever else the comment says
    toolRadius,
    cornerRadius,
    sideAngle,
    includedAngle,
    tipDiameter,
    fluteLength,
    threadSize,  ///< of a metric thread
    height,      ///< H register
    notOfCutter, ///< a size of something else
};

struct LabelRow {
    std::string_view words; ///< upper case, separated by one blank
    CommentField field;
    /// The number must be joined to the label or follow "=" or ":"; a blank is not enough.
    bool closely = false;
};

/// A row without a shape is about something that is not a rotating cutter.
struct ShapeRow {
    std::string_view words;
    const char* shape; ///< key of cutterShapes(); empty: none
};

/// The row whose words are at token `at`, the longest one; null if there is none.
[[nodiscard]] const LabelRow* labelAt(std::span<const CommentToken> tokens, std::size_t at);
/// How many tokens the words of a row span.
[[nodiscard]] std::size_t wordCount(std::string_view words);

/// Where the words of a shape are.
struct ShapePlace {
    const ShapeRow* row = nullptr;
    std::size_t first = 0; ///< token
    std::size_t last = 0;  ///< index of the last token of the words
};
/// The most specific shape that the tokens name; a null row where they name none.
[[nodiscard]] ShapePlace shapeIn(std::span<const CommentToken> tokens);

/// Whether a word names a tool without a particular shape.
[[nodiscard]] bool namesTool(std::string_view word);
/// Whether a word shows that the sizes in a comment without a tool number are those of something else.
[[nodiscard]] bool namesSomethingElse(std::string_view word);

} // namespace proveout
