// SPDX-License-Identifier: GPL-3.0-or-later
// Splits an ASCII STL into words. Lines end in LF, CR LF or CR alone; white space is that of ASCII and
// Unicode, including the byte order mark.
#pragma once

#include <cstddef>
#include <string_view>

#include "core/base/diagnostic.h"

namespace proveout {

/// A word of the file and its place.
struct StlWord {
    std::string_view text;
    TextRange where;

    /// `key` is in lower case; case of the word is ignored.
    [[nodiscard]] bool is(std::string_view key) const;
};

/// The text without the white space, in UTF-8, at its beginning.
[[nodiscard]] std::string_view withoutLeadingSpace(std::string_view text);

/// Splits the text into words and counts lines. Value type: use a copy to look ahead.
class StlWords {
public:
    explicit StlWords(std::string_view text) : m_text(text) {}

    /// The next word; an empty one at the end.
    [[nodiscard]] StlWord next();

    /// Skips the name after `solid` or `endsolid`: the rest of the line, except the first facet of a solid
    /// that is written on the same line. True: such a facet is next.
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
