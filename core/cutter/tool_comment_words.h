// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of words that comments name tools and their sizes with. Inside the room only.
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
    diameter,     ///< of whatever the comment is about
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
    std::string_view words; ///< upper case, a blank between two
    CommentField field;
    /// The number is joined to the label or follows "=" or ":"; a blank is not enough.
    bool closely = false;
};

/// A row without a shape is about what is not a rotating cutter.
struct ShapeRow {
    std::string_view words;
    const char* shape; ///< key of cutterShapes(); empty: none
};

/// The row whose words stand at token `at`, the longest one; null where none does.
[[nodiscard]] const LabelRow* labelAt(std::span<const CommentToken> tokens, std::size_t at);
/// How many tokens the words of a row are.
[[nodiscard]] std::size_t wordCount(std::string_view words);

/// Where the words of a shape stand.
struct ShapePlace {
    const ShapeRow* row = nullptr;
    std::size_t first = 0; ///< token
    std::size_t last = 0;  ///< token, of the words
};
/// The most specific shape that the tokens name; a null row where they name none.
[[nodiscard]] ShapePlace shapeIn(std::span<const CommentToken> tokens);

/// Whether a word names a tool of no particular shape.
[[nodiscard]] bool namesTool(std::string_view word);
/// Whether a word says that the sizes in a comment are of something else, in a comment without a tool number.
[[nodiscard]] bool namesSomethingElse(std::string_view word);

} // namespace proveout
