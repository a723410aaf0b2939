// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/npy_header.h"

#include <charconv>
#include <fmt/format.h>
#include <system_error>
#include <utility>

#include "core/formats/array_findings.h"

namespace proveout {

namespace {

constexpr std::string_view kMagic = "\x93NUMPY";
constexpr std::size_t kVersionEnd = 8;
constexpr std::size_t kAlignment = 64;

/// Reads the few forms of Python literals that NumPy writes. The first error is kept.
class LiteralReader {
public:
    explicit LiteralReader(std::string_view text) : m_text(text) {}

    [[nodiscard]] bool failed() const { return m_failed; }
    [[nodiscard]] std::size_t at() const { return m_at; }
    [[nodiscard]] bool atEnd() {
        skipSpaces();
        return m_at == m_text.size();
    }

    /// Consumes `token` if it comes next.
    bool accept(std::string_view token) {
        skipSpaces();
        if (m_failed || !m_text.substr(m_at).starts_with(token))
            return false;
        m_at += token.size();
        return true;
    }
    void expect(std::string_view token) {
        if (!accept(token))
            m_failed = true;
    }

    std::string string() {
        skipSpaces();
        const char quote = m_at < m_text.size() ? m_text[m_at] : '\0';
        const auto end =
            quote == '\'' || quote == '"' ? m_text.find(quote, m_at + 1) : std::string_view::npos;
        if (m_failed || end == std::string_view::npos) {
            m_failed = true;
            return {};
        }
        std::string out(m_text.substr(m_at + 1, end - m_at - 1));
        m_at = end + 1;
        return out;
    }

    bool boolean() {
        if (accept("True"))
            return true;
        expect("False");
        return false;
    }

    std::uint64_t number() {
        skipSpaces();
        std::uint64_t value = 0;
        const auto [end, error] = std::from_chars(m_text.data() + m_at, m_text.data() + m_text.size(), value);
        if (error != std::errc()) {
            m_failed = true;
            return 0;
        }
        m_at = static_cast<std::size_t>(end - m_text.data());
        accept("L"); // the suffix of long integers in Python 2
        return value;
    }

    std::vector<std::uint64_t> tuple() {
        std::vector<std::uint64_t> out;
        expect("(");
        while (!m_failed && !accept(")")) {
            out.push_back(number());
            if (!accept(",")) {
                expect(")");
                break;
            }
        }
        return out;
    }

private:
    void skipSpaces() {
        while (m_at < m_text.size() &&
               (m_text[m_at] == ' ' || (m_text[m_at] >= '\t' && m_text[m_at] <= '\r')))
            ++m_at;
    }

    std::string_view m_text;
    std::size_t m_at = 0;
    bool m_failed = false;
};

tl::unexpected<Diagnostics> badHeader(std::size_t offset) {
    return failure(array_finding::kNpyHeader, {std::to_string(offset)});
}

/// Reads the dictionary at `start`; each key must occur exactly once.
Result<NpyHeader> readDictionary(std::string_view text, std::size_t start) {
    NpyHeader header;
    LiteralReader literal(text);
    int types = 0;
    int orders = 0;
    int shapes = 0;
    literal.expect("{");
    while (!literal.failed() && !literal.accept("}")) {
        const std::string key = literal.string();
        literal.expect(":");
        if (key == "descr" && ++types == 1)
            header.type = literal.string();
        else if (key == "fortran_order" && ++orders == 1)
            header.fortranOrder = literal.boolean();
        else if (key == "shape" && ++shapes == 1)
            header.shape = literal.tuple();
        else
            return badHeader(start + literal.at());
        if (!literal.accept(",")) {
            literal.expect("}");
            break;
        }
    }
    if (literal.failed() || !literal.atEnd() || types + orders + shapes != 3)
        return badHeader(start + literal.at());
    return header;
}

std::size_t littleEndian(std::string_view bytes) {
    std::size_t value = 0;
    for (std::size_t i = bytes.size(); i-- > 0;)
        value = value << 8 | static_cast<unsigned char>(bytes[i]);
    return value;
}

} // namespace

Result<NpyHeader> readNpyHeader(std::string_view bytes) {
    if (!bytes.starts_with(kMagic))
        return failure(array_finding::kNotNpy);
    if (bytes.size() < kVersionEnd)
        return badHeader(bytes.size());
    const int version = static_cast<unsigned char>(bytes[kMagic.size()]);
    if (version < 1 || version > 3)
        return failure(array_finding::kNpyVersion, {std::to_string(version)});
    // Version 1 has two bytes for the length of the dictionary, later versions four.
    const std::size_t textStart = kVersionEnd + (version == 1 ? 2 : 4);
    if (bytes.size() < textStart)
        return badHeader(bytes.size());
    const std::size_t length = littleEndian(bytes.substr(kVersionEnd, textStart - kVersionEnd));
    if (length > bytes.size() - textStart)
        return failure(array_finding::kNpyCutOffHeader,
                       {std::to_string(bytes.size()), std::to_string(textStart + length)});
    auto header = readDictionary(bytes.substr(textStart, length), textStart);
    if (header)
        header->dataStart = textStart + length;
    return header;
}

std::string npyHeader(int rows, int columns, std::string_view type) {
    std::string text =
        fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}, {}), }}", type, rows, columns);
    const std::size_t start = kVersionEnd + 2;
    while ((start + text.size() + 1) % kAlignment != 0)
        text.push_back(' ');
    text.push_back('\n');
    std::string header(kMagic);
    header += {'\1', '\0', static_cast<char>(text.size() & 0xff), static_cast<char>(text.size() >> 8)};
    return header + text;
}

} // namespace proveout
