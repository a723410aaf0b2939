// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <charconv>
#include <limits>
#include <string>
#include <system_error>

#include "core/formats/mesh_findings.h"
#include "core/formats/stl_facets.h"
#include "core/formats/stl_words.h"

namespace proveout {

namespace {

constexpr std::size_t kShownLength = 40; ///< of a wrong word in a message

tl::unexpected<Diagnostics> unexpectedWord(const StlWord& word, const char* wanted) {
    auto failed = word.text.empty() ? failure(mesh_finding::kStlCutOff, {wanted})
                                    : failure(mesh_finding::kStlSyntax,
                                              {std::string(word.text.substr(0, kShownLength)), wanted});
    failed.value().front().where = word.where;
    return failed;
}

/// from_chars does not distinguish too large from too small: a facet with a too large number counts as not
/// finite, a too small number is zero.
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
        for (StlWord word = m_words.next(); !word.text.empty(); word = m_words.next()) {
            if (!word.is("solid"))
                return unexpectedWord(word, "solid");
            static_cast<void>(m_words.skipName());
            if (auto solid = parseSolid(); !solid)
                return tl::unexpected(std::move(solid.error()));
        }
        return std::move(m_out);
    }

private:
    /// Facets up to `endsolid`, and those of further solids on the same line.
    Result<void> parseSolid() {
        for (;;) {
            const StlWord word = m_words.next();
            if (word.is("endsolid")) {
                if (m_words.skipName())
                    continue;
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
        const StlWord word = m_words.next();
        if (!word.is(key))
            return unexpectedWord(word, key);
        return {};
    }

    Result<void> parsePoint(std::array<float, 3>& point) {
        for (float& value : point) {
            const StlWord word = m_words.next();
            const char* first = word.text.data();
            const char* last = first + word.text.size();
            if (first != last && *first == '+') // from_chars does not accept a plus
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

    void warnNoEnd(const StlWord& end) {
        Diagnostic warning = diagnosticOf(mesh_finding::kStlNoEndsolid);
        warning.where = end.where;
        m_out.warnings.push_back(std::move(warning));
    }

    StlWords m_words;
    StlFacets m_out;
};

} // namespace

Result<StlFacets> readAsciiFacets(std::string_view text) {
    return FacetParser(text).parse();
}

} // namespace proveout
