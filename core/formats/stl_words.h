// SPDX-License-Identifier: GPL-3.0-or-later
// The words of an ASCII STL. Lines end in LF, CR LF or CR alone; white space is that of ASCII and Unicode,
// the byte order mark included.
#pragma once

#include <cstddef>
#include <string_view>

#include "core/base/diagnostic.h"

namespace proveout {

/// A word of the file and its place.
struct StlWord {
    std::string_view text;
    TextRange where;

    /// `key` is in lower case; the word may have any.
    [[nodiscard]] bool is(std::string_view key) const;
};

/// What follows the white space, in UTF-8, at the begin of the text.
[[nodiscard]] std::string_view withoutLeadingSpace(std::string_view text);

/// Cuts the text into words and counts lines. Value type: a copy looks ahead.
class StlWords {
public:
    explicit StlWords(std::string_view text) : m_text(text) {}

    /// The next word; an empty one at the end.
    [[nodiscard]] StlWord next();

    /// Skips the name after `solid` or `endsolid`: the rest of the line, whatever it holds, but for the first
    /// facet of a solid that is written on the same line. True: such a facet is next.
    [[nodiscard]] bool skipName();

private:
    [[nodiscard]] std::size_t spaceHere() const;
    [[nodiscard]] bool lineEndsHere() const;
    [[nodiscard]] bool facetBeginsHere() const;
    void skipSpace();

    std::string_view m_text;
    std::size_t m_at = 0;
    std::size_t m_lineStart = 0;
    int m_line = 1;
};

} // namespace proveout
