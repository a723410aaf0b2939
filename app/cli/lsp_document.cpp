// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/lsp_document.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <functional>
#include <utility>

#include "app/cli/lsp_json.h"
#include "core/base/utf8.h"

namespace proveout::cli {

namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
constexpr std::string_view kFileScheme = "file://";

std::size_t unitsOf(const Utf8Character& character, PositionEncoding encoding) {
    if (encoding == PositionEncoding::utf8)
        return character.length;
    return character.code > 0xffff ? 2 : 1;
}

NcText textWithMark(std::string text) {
    if (!text.starts_with(kByteOrderMark))
        return NcText(std::move(text));
    return NcText().replaced(0, 0, text);
}

/// The bytes before a line. The runs of a text are its bytes in memory.
std::size_t offsetOfLine(const NcText& text, std::size_t line) {
    const char* const begin = text.line(line).data();
    std::size_t before = 0;
    for (const std::string_view run : text.runs()) {
        const std::less<> isBefore;
        if (!isBefore(begin, run.data()) && isBefore(begin, run.data() + run.size()))
            return before + static_cast<std::size_t>(begin - run.data());
        before += run.size();
    }
    return text.size();
}

std::optional<int> hexDigit(char c) {
    if (std::isxdigit(static_cast<unsigned char>(c)) == 0)
        return {};
    return std::isdigit(static_cast<unsigned char>(c)) != 0
               ? c - '0'
               : std::tolower(static_cast<unsigned char>(c)) - 'a' + 10;
}

} // namespace

std::size_t byteOf(std::string_view line, std::size_t position, PositionEncoding encoding) {
    std::size_t byte = 0;
    for (std::size_t units = 0; byte < line.size();) {
        const Utf8Character character = firstCharacter(line.substr(byte));
        units += unitsOf(character, encoding);
        if (units > position)
            break;
        byte += character.length;
    }
    return byte;
}

std::size_t positionOf(std::string_view line, std::size_t byte, PositionEncoding encoding) {
    std::size_t units = 0;
    for (std::size_t at = 0; at < std::min(byte, line.size());) {
        const Utf8Character character = firstCharacter(line.substr(at));
        at += character.length;
        if (at > byte)
            break;
        units += unitsOf(character, encoding);
    }
    return units;
}

nlohmann::json rangeInLine(const NcText& text, std::size_t line, std::size_t begin, std::size_t end,
                           PositionEncoding encoding) {
    const std::string_view content = text.line(line);
    const auto position = [&](std::size_t byte) {
        return nlohmann::json{{"line", line}, {"character", positionOf(content, byte, encoding)}};
    };
    return {{"start", position(begin)}, {"end", position(end)}};
}

std::filesystem::path fileOfUri(std::string_view uri) {
    if (!uri.starts_with(kFileScheme))
        return {};
    uri.remove_prefix(std::min(uri.find('/', kFileScheme.size()), uri.size()));
    std::string path;
    for (std::size_t at = 0; at < uri.size(); ++at) {
        const auto high = uri[at] == '%' && at + 2 < uri.size() ? hexDigit(uri[at + 1]) : std::nullopt;
        const auto low = high ? hexDigit(uri[at + 2]) : std::nullopt;
        path.push_back(low ? static_cast<char>(*high * 16 + *low) : uri[at]);
        at += low ? 2 : 0;
    }
    return path.find('\0') == std::string::npos ? std::filesystem::path(path) : std::filesystem::path();
}

std::string uriOfFile(const std::filesystem::path& file) {
    std::string uri(kFileScheme);
    for (const char c : file.string()) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) != 0 || std::string_view("/-._~").find(c) != std::string_view::npos)
            uri.push_back(c);
        else
            uri += fmt::format("%{:02X}", byte);
    }
    return uri;
}

LspDocument::LspDocument(std::string text, PositionEncoding encoding)
    : m_text(textWithMark(std::move(text))), m_encoding(encoding) {}

std::size_t LspDocument::offsetOf(const nlohmann::json& position) const {
    const std::size_t line = indexIn(position, "line");
    const std::size_t character = indexIn(position, "character");
    if (line >= m_text.lineCount())
        return m_text.size();
    return offsetOfLine(m_text, line) + byteOf(m_text.line(line), character, m_encoding);
}

void LspDocument::change(const nlohmann::json& change) {
    const std::string& text = stringIn(change, "text");
    if (!change.contains("range") || change["range"].is_null()) {
        m_text = textWithMark(text);
        return;
    }
    const nlohmann::json& range = objectIn(change, "range");
    const std::size_t begin = offsetOf(objectIn(range, "start"));
    const std::size_t end = std::max(begin, offsetOf(objectIn(range, "end")));
    if (m_text.size() - (end - begin) + text.size() > kLargest)
        throw InvalidParameter("The document would be too large.");
    m_text = m_text.replaced(begin, end - begin, text);
}

std::size_t LspDocument::markBytes() const {
    return m_text.line(0).starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
}

NcText LspDocument::program() const {
    return markBytes() > 0 ? NcText(m_text.toString()) : m_text;
}

} // namespace proveout::cli
