// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/lsp_transport.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstdio>
#include <fmt/format.h>

namespace proveout::cli {

namespace {

constexpr std::string_view kLengthField = "content-length";
constexpr std::string_view kHeaderStart = "Content-Length:"; ///< as every client writes it
constexpr std::size_t kLongestHeader = 8192;                 ///< bytes
constexpr std::size_t kLongestStart = 64;                    ///< bytes of a line with the length

bool isOfFieldName(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-';
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t'))
        text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r'))
        text.remove_suffix(1);
    return text;
}

bool isLengthField(std::string_view name) {
    return std::ranges::equal(name, kLengthField, [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) == static_cast<unsigned char>(b);
    });
}

std::optional<std::size_t> lengthIn(std::string_view value) {
    std::size_t length = 0;
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), length);
    if (error != std::errc() || end != value.data() + value.size())
        return {};
    return length;
}

} // namespace

bool LspInput::fill() {
    constexpr std::size_t kChunk = 65536;
    const std::size_t before = m_bytes.size();
    m_bytes.resize(before + kChunk);
    const std::size_t count = m_ended ? 0 : m_read(m_bytes.data() + before, kChunk);
    m_bytes.resize(before + count);
    m_ended = m_ended || count == 0;
    return count > 0;
}

/// Line breaks cannot be in a JSON text, but between its parts, so a line with a length is a header.
bool LspInput::searchHeader() {
    while (true) {
        for (std::size_t at = 0; (at = m_bytes.find(kHeaderStart, at)) != std::string::npos; ++at) {
            const std::size_t end = m_bytes.find("\r\n", at);
            if (end == std::string::npos && m_bytes.size() - at > kLongestStart)
                continue;
            if (end != std::string::npos) {
                const std::size_t value = at + kHeaderStart.size();
                if (!lengthIn(trimmed(std::string_view(m_bytes).substr(value, end - value))))
                    continue;
                m_bytes.erase(0, at);
                return true;
            }
            m_bytes.erase(0, at);
            break;
        }
        if (!m_bytes.starts_with(kHeaderStart) && m_bytes.size() > kLongestStart)
            m_bytes.erase(0, m_bytes.size() - kLongestStart);
        if (!fill())
            return false;
    }
}

/// The first byte of the header is skipped, so that the search does not find it again.
bool LspInput::lose(const std::string& sentence) {
    m_complain(sentence);
    m_bytes.erase(0, 1);
    m_lost = true;
    return false;
}

/// Reads the line at `at`, and moves `at` to after it; false at the end, or if it is too long.
bool LspInput::readLine(std::size_t& at, std::string_view& line) {
    std::size_t end = std::string::npos;
    while ((end = m_bytes.find('\n', at)) == std::string::npos)
        if (m_bytes.size() > kLongestHeader || !fill())
            return false;
    line = trimmed(std::string_view(m_bytes).substr(at, end - at));
    at = end + 1;
    return end <= kLongestHeader;
}

std::optional<LspInput::Header> LspInput::readHeader() {
    Header header;
    const auto fail = [this](const std::string& sentence) {
        lose(sentence);
        return std::optional<Header>();
    };
    bool begun = false;
    for (std::string_view line; readLine(header.end, line);) {
        if (line.empty() && !begun)
            continue;
        if (line.empty() && header.length)
            return header;
        if (line.empty())
            return fail("A header has no Content-Length.");
        begun = true;
        const std::size_t colon = line.find(':');
        if (colon == std::string_view::npos || !std::ranges::all_of(line.substr(0, colon), isOfFieldName))
            return fail("A line of a header is not a field.");
        if (!isLengthField(line.substr(0, colon)))
            continue;
        const auto length = lengthIn(trimmed(line.substr(colon + 1)));
        if (!length || (header.length && header.length != length))
            return fail("Content-Length is not a valid number of bytes.");
        if (*length > m_largest)
            return fail(fmt::format("A message of {} bytes is too large; the limit is {} bytes.", *length,
                                    m_largest));
        header.length = length;
    }
    if (m_ended) {
        m_bytes.clear();
        return {};
    }
    return fail("A header is too long.");
}

std::optional<std::string> LspInput::next() {
    while (!m_ended || !m_bytes.empty()) {
        if (m_lost && !searchHeader())
            return {};
        m_lost = false;
        const auto header = readHeader();
        if (!header)
            continue;
        const std::size_t end = header->end + *header->length;
        while (m_bytes.size() < end)
            if (!fill()) {
                m_complain("The input ends within a message.");
                return {};
            }
        std::string message = m_bytes.substr(header->end, *header->length);
        m_bytes.erase(0, end);
        if (m_bytes.capacity() > 4 * kLongestHeader + m_bytes.size())
            m_bytes.shrink_to_fit();
        return message;
    }
    return {};
}

void LspOutput::send(const nlohmann::json& message) {
    const std::string text = message.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    const std::string header = fmt::format("Content-Length: {}\r\n\r\n", text.size());
    const std::scoped_lock lock(m_mutex);
    m_failed = m_failed || std::fwrite(header.data(), 1, header.size(), stdout) != header.size() ||
               std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0;
}

void LspOutput::notify(const char* method, nlohmann::json parameters) {
    send({{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(parameters)}});
}

bool LspOutput::failed() {
    const std::scoped_lock lock(m_mutex);
    return m_failed;
}

} // namespace proveout::cli
