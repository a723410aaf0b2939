// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/json_document.h"

#include <iterator>
#include <vector>

#include "core/formats/job_findings.h"

namespace proveout {

namespace {

using nlohmann::json;

// The error number and text that the library uses.
constexpr int kOutOfRange = 406;
constexpr std::string_view kUnexpectedEnd = "unexpected end of input";

/// Iterates over the bytes of a text. Copies share the position, so that the owner can see how far the parser
/// has read.
class SharedIterator {
public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    explicit SharedIterator(const char*& at) : m_at(&at) {}

    reference operator*() const { return **m_at; }
    SharedIterator& operator++() {
        ++*m_at;
        return *this;
    }
    friend bool operator==(const SharedIterator& a, const SharedIterator& b) { return *a.m_at == *b.m_at; }

private:
    const char** m_at;
};

/// Walks through the text once before anything is built and determines the depth, and the places of all
/// fields and of every error (the exceptions of the actual parser do not give the place of a number out of
/// range).
class SyntaxCheck : public nlohmann::json_sax<json> {
public:
    SyntaxCheck(std::string_view text, int depth)
        : m_next(text.data()), m_end(text.data() + text.size()), m_counted(text.data()),
          m_lineStart(text.data()), m_depthLeft(depth) {}

    /// Whether the text is valid JSON within the depth. Call it only once.
    [[nodiscard]] bool passes() {
        return json::sax_parse(SharedIterator(m_next), SharedIterator(m_end), this);
    }
    [[nodiscard]] TextRange errorPlace() const { return m_error; }
    [[nodiscard]] bool tooDeep() const { return m_tooDeep; }
    [[nodiscard]] JsonPlaces releasePlaces() { return std::move(m_places); }

    bool null() override { return true; }
    bool boolean(bool /*value*/) override { return true; }
    bool number_integer(number_integer_t /*value*/) override { return true; }
    bool number_unsigned(number_unsigned_t /*value*/) override { return true; }
    bool number_float(number_float_t /*value*/, const string_t& /*text*/) override { return true; }
    bool string(string_t& /*value*/) override { return true; }
    bool binary(binary_t& /*value*/) override { return true; }
    bool key(string_t& value) override {
        if (m_open.back() != JsonPlace::kNoObject)
            m_field = m_places.insert_or_assign({m_open.back(), value}, JsonPlace{placeOfName()}).first;
        return true;
    }
    bool start_object(std::size_t /*size*/) override {
        if (m_open.empty())
            return enter(0);
        if (m_open.back() == JsonPlace::kNoObject)
            return enter(JsonPlace::kNoObject);
        m_field->second.object = ++m_lastObject;
        return enter(m_lastObject);
    }
    bool start_array(std::size_t /*size*/) override { return enter(JsonPlace::kNoObject); }
    bool end_object() override { return leave(); }
    bool end_array() override { return leave(); }
    bool parse_error(std::size_t /*offset*/, const std::string& token,
                     const nlohmann::detail::exception& error) override {
        if (error.id == kOutOfRange) {
            // The character after a number was read already, unless the text ended there.
            const char* end = *(m_next - 1) == token.back() ? m_next : m_next - 1;
            m_error = placeOf(end - token.size());
            m_error.length = static_cast<int>(token.size());
            return false;
        }
        // The last byte read is the wrong one; at the end of the text there was none to read. At the end of
        // the text, only the message distinguishes the two cases.
        const bool atEnd = std::string_view(error.what()).find(kUnexpectedEnd) != std::string_view::npos;
        m_error = placeOf(atEnd ? m_next : m_next - 1);
        return false;
    }

private:
    /// Objects within arrays are not numbered.
    bool enter(std::size_t object) {
        m_open.push_back(object);
        m_tooDeep = --m_depthLeft < 0;
        return !m_tooDeep;
    }
    bool leave() {
        m_open.pop_back();
        ++m_depthLeft;
        return true;
    }
    /// The parser has just read the quotation mark that closes the name.
    [[nodiscard]] TextRange placeOfName() {
        const char* begin = m_next - 2;
        while (*begin != '"' || isEscaped(begin))
            --begin;
        TextRange where = placeOf(begin);
        where.length = static_cast<int>(m_next - begin);
        return where;
    }
    [[nodiscard]] static bool isEscaped(const char* quote) {
        const char* backslash = quote - 1;
        while (*backslash == '\\')
            --backslash;
        return (quote - backslash) % 2 == 0;
    }
    /// Moves only forwards, so that the lines of a text are counted once.
    [[nodiscard]] TextRange placeOf(const char* at) {
        for (; m_counted < at; ++m_counted) {
            if (*m_counted == '\n') {
                ++m_line;
                m_lineStart = m_counted + 1;
            }
        }
        return {m_line, static_cast<int>(at - m_lineStart) + 1, 0};
    }

    const char* m_next; ///< after the last byte that was read
    const char* m_end;
    const char* m_counted;
    const char* m_lineStart;
    int m_line = 1;
    int m_depthLeft;
    bool m_tooDeep = false;
    TextRange m_error;
    JsonPlaces m_places;
    JsonPlaces::iterator m_field;
    std::vector<std::size_t> m_open;
    std::size_t m_lastObject = 0;
};

} // namespace

Result<JsonDocument> parseJson(std::string_view text, int depth) {
    SyntaxCheck check(text, depth);
    if (check.passes())
        return JsonDocument{json::parse(text), check.releasePlaces()};
    if (check.tooDeep())
        return failure(job_finding::kJsonDepth, {std::to_string(depth)});
    auto failed = failure(job_finding::kJsonSyntax);
    failed.value().front().where = check.errorPlace();
    return failed;
}

} // namespace proveout
