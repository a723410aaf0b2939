// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/stl_words.h"

#include <algorithm>
#include <array>

#include "core/base/utf8.h"

namespace proveout {

namespace {

constexpr std::size_t kLongestWord = 1'000'000; ///< the most bytes that a message marks

/// White space beyond ASCII, with the byte order mark last. Bytes that are not UTF-8 count as themselves, so
/// that the no-break space of Latin-1 is included.
constexpr std::array<char32_t, 19> kSpaces{0x85,   0xa0,   0x1680, 0x2000, 0x2001, 0x2002, 0x2003,
                                           0x2004, 0x2005, 0x2006, 0x2007, 0x2008, 0x2009, 0x200a,
                                           0x2028, 0x2029, 0x202f, 0x3000, 0xfeff};

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool isLineEnd(char c) {
    return c == '\n' || c == '\r';
}

bool isAscii(char c) {
    return static_cast<unsigned char>(c) < 0x80;
}

/// The length in bytes of the white-space character at the beginning of the text; 0: there is none.
std::size_t spaceLength(std::string_view text) {
    if (text.empty())
        return 0;
    const char c = text.front();
    if (isAscii(c))
        return c == ' ' || (c >= '\t' && c <= '\r') ? 1 : 0;
    const Utf8Character character = firstCharacter(text);
    return std::ranges::find(kSpaces, character.code) != kSpaces.end() ? character.length : 0;
}

bool mayBeNumber(const StlWord& word) {
    return word.text.find_first_of("0123456789") != std::string_view::npos;
}

} // namespace

bool StlWord::is(std::string_view key) const {
    return std::equal(text.begin(), text.end(), key.begin(), key.end(),
                      [](char a, char b) { return lower(a) == b; });
}

std::string_view withoutLeadingSpace(std::string_view text) {
    while (const std::size_t space = spaceLength(text))
        text.remove_prefix(space);
    return text;
}

StlWord StlWords::next() {
    skipSpace();
    StlWord word;
    word.where = {m_line, static_cast<int>(m_at - m_lineStart) + 1, 0};
    const std::size_t start = m_at;
    // By characters: the second byte of a character may look like a no-break space of Latin-1.
    while (m_at < m_text.size() && spaceHere() == 0)
        m_at += isAscii(m_text[m_at]) ? 1 : firstCharacter(m_text.substr(m_at)).length;
    word.text = m_text.substr(start, m_at - start);
    word.where.length = static_cast<int>(std::min(word.text.size(), kLongestWord));
    return word;
}

bool StlWords::skipName() {
    while (!lineEndsHere()) {
        if (facetBeginsHere())
            return true;
        if (const std::size_t space = spaceHere())
            m_at += space;
        else
            static_cast<void>(next());
    }
    return false;
}

std::size_t StlWords::spaceHere() const {
    return spaceLength(m_text.substr(m_at));
}

bool StlWords::lineEndsHere() const {
    return m_at >= m_text.size() || isLineEnd(m_text[m_at]);
}

/// Checks more than the keyword alone, which a name may contain. Checks the first letter first, because this
/// is called for each word of a long name.
bool StlWords::facetBeginsHere() const {
    if (lower(m_text[m_at]) != 'f')
        return false;
    StlWords ahead = *this;
    return ahead.next().is("facet") && ahead.next().is("normal") && mayBeNumber(ahead.next()) &&
           mayBeNumber(ahead.next()) && mayBeNumber(ahead.next()) && ahead.next().is("outer");
}

void StlWords::skipSpace() {
    while (const std::size_t space = spaceHere()) {
        const char c = m_text[m_at];
        const bool ended = c == '\n' && m_at > 0 && m_text[m_at - 1] == '\r'; // by the CR of CR LF
        m_at += space;
        if (!isLineEnd(c))
            continue;
        m_line += ended ? 0 : 1;
        m_lineStart = m_at;
    }
}

} // namespace proveout
