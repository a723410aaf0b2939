// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <string>
#include <system_error>

#include "core/base/text.h"
#include "core/formats/stl_facets.h"

namespace proveout {

namespace {

constexpr std::size_t kShownLength = 40; ///< of a wrong word in a message

bool isSpace(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// A word of the file and where it stands.
struct Word {
    std::string_view text;
    TextRange where;

    [[nodiscard]] bool is(std::string_view key) const {
        return std::equal(text.begin(), text.end(), key.begin(), key.end(),
                          [](char a, char b) { return lower(a) == b; });
    }
};

/// Cuts the text into words and counts lines.
class Words {
public:
    explicit Words(std::string_view text) : m_text(text) {}

    /// The next word; an empty one at the end.
    Word next() {
        while (m_at < m_text.size() && isSpace(m_text[m_at]))
            step();
        Word word;
        word.where = {m_line, static_cast<int>(m_at - m_lineStart) + 1, 0};
        const std::size_t start = m_at;
        while (m_at < m_text.size() && !isSpace(m_text[m_at]))
            ++m_at;
        word.text = m_text.substr(start, m_at - start);
        word.where.length = static_cast<int>(std::min<std::size_t>(word.text.size(), 1'000'000));
        return word;
    }

    /// The name behind `solid` and `endsolid` is the rest of the line, whatever it holds.
    void skipLine() {
        while (m_at < m_text.size() && m_text[m_at] != '\n')
            ++m_at;
    }

private:
    void step() {
        if (m_text[m_at++] == '\n') {
            ++m_line;
            m_lineStart = m_at;
        }
    }

    std::string_view m_text;
    std::size_t m_at = 0;
    std::size_t m_lineStart = 0;
    int m_line = 1;
};

tl::unexpected<Diagnostics> unexpectedWord(const Word& word, const char* wanted) {
    auto failed = word.text.empty()
                      ? failure("stl-cut-off",
                                PROVEOUT_TEXT("Core", "The file ends where \"{}\" should stand."), {wanted})
                      : failure("stl-syntax", PROVEOUT_TEXT("Core", "\"{}\" stands where \"{}\" should."),
                                {std::string(word.text.substr(0, kShownLength)), wanted});
    failed.value().front().where = word.where;
    return failed;
}

/// from_chars does not tell too large from too small: a facet with the first is counted as not finite, the
/// second is zero.
float outOfRange(std::string_view number) {
    const auto exponent = number.find_first_of("eE");
    const bool tiny = exponent != std::string_view::npos && number.substr(exponent + 1).starts_with('-');
    return tiny ? 0.0F : std::numeric_limits<float>::infinity();
}

/// The recursive descent over facets; the first error ends it.
class FacetParser {
public:
    explicit FacetParser(std::string_view text) : m_words(text) {}

    Result<StlFacets> parse() {
        for (Word word = m_words.next(); !word.text.empty(); word = m_words.next()) {
            if (!word.is("solid"))
                return unexpectedWord(word, "solid");
            m_words.skipLine();
            if (auto solid = parseSolid(); !solid)
                return tl::unexpected(std::move(solid.error()));
        }
        return std::move(m_out);
    }

private:
    /// Facets up to `endsolid`.
    Result<void> parseSolid() {
        for (;;) {
            const Word word = m_words.next();
            if (word.is("endsolid")) {
                m_words.skipLine();
                return {};
            }
            if (word.text.empty()) {
                warnNoEnd(word);
                return {};
            }
            if (!word.is("facet"))
                return unexpectedWord(word, "facet");
            if (auto facet = parseFacet(); !facet)
                return facet;
        }
    }

    Result<void> parseFacet() {
        StlFacet facet{};
        if (auto found = expect("normal"); !found)
            return found;
        if (auto read = parsePoint(facet[0]); !read)
            return read;
        for (const char* key : {"outer", "loop"}) {
            if (auto found = expect(key); !found)
                return found;
        }
        for (std::size_t corner = 1; corner < facet.size(); ++corner) {
            if (auto found = expect("vertex"); !found)
                return found;
            if (auto read = parsePoint(facet[corner]); !read)
                return read;
        }
        for (const char* key : {"endloop", "endfacet"}) {
            if (auto found = expect(key); !found)
                return found;
        }
        m_out.facets.push_back(facet);
        return {};
    }

    Result<void> expect(const char* key) {
        const Word word = m_words.next();
        if (!word.is(key))
            return unexpectedWord(word, key);
        return {};
    }

    Result<void> parsePoint(std::array<float, 3>& point) {
        for (float& value : point) {
            const Word word = m_words.next();
            const char* first = word.text.data();
            const char* last = first + word.text.size();
            if (first != last && *first == '+') // from_chars takes no plus
                ++first;
            double number = 0;
            const auto [end, error] = std::from_chars(first, last, number);
            if (end != last || error == std::errc::invalid_argument || word.text.empty())
                return unexpectedWord(word, "number");
            value =
                error == std::errc::result_out_of_range ? outOfRange(word.text) : static_cast<float>(number);
        }
        return {};
    }

    void warnNoEnd(const Word& end) {
        Diagnostic warning;
        warning.severity = Severity::warning;
        warning.id = "stl-no-endsolid";
        warning.text = PROVEOUT_TEXT("Core", "The file ends without \"endsolid\"; it may have been cut off.");
        warning.where = end.where;
        m_out.warnings.push_back(std::move(warning));
    }

    Words m_words;
    StlFacets m_out;
};

} // namespace

Result<StlFacets> readAsciiFacets(std::string_view text) {
    return FacetParser(text).parse();
}

} // namespace proveout
