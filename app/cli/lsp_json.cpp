// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/lsp_json.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <string_view>
#include <utility>

#include "core/base/utf8.h"

namespace proveout::cli {

namespace {

constexpr std::size_t kDeepest = 64;
constexpr std::size_t kMostValues = 1'000'000;
constexpr std::string_view kReplacement = "\xef\xbf\xbd"; ///< U+FFFD

/// A value costs many times the memory of its text, so they are counted before any is made.
bool isWithinLimits(std::string_view text) {
    std::size_t depth = 0;
    std::size_t values = 0;
    bool quoted = false;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const char c = text[at];
        if (quoted) {
            at += c == '\\' ? 1 : 0;
            quoted = c != '"';
        } else if (c == '"') {
            quoted = true;
        } else if (c == '[' || c == '{') {
            if (++depth > kDeepest)
                return false;
            ++values;
        } else if (c == ']' || c == '}') {
            depth -= depth > 0 ? 1 : 0;
        } else if (c == ',' && ++values > kMostValues) {
            return false;
        }
    }
    return true;
}

/// The value of "\uXXXX" at `at`; nothing if it is something else.
std::optional<unsigned> escapeAt(std::string_view text, std::size_t at) {
    constexpr std::size_t kLength = 6;
    if (text.size() < at + kLength || text[at] != '\\' || text[at + 1] != 'u')
        return {};
    unsigned value = 0;
    for (const char c : text.substr(at + 2, kLength - 2)) {
        if (std::isxdigit(static_cast<unsigned char>(c)) == 0)
            return {};
        const int digit = std::isdigit(static_cast<unsigned char>(c)) != 0
                              ? c - '0'
                              : std::tolower(static_cast<unsigned char>(c)) - 'a' + 10;
        value = value * 16 + static_cast<unsigned>(digit);
    }
    return value;
}

bool isSurrogate(unsigned value, unsigned first) {
    return value >= first && value < first + 0x400;
}

/// The number of bytes of half a surrogate pair, written as if it were a character.
std::size_t rawSurrogate(std::string_view text) {
    const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(text[at]); };
    return text.size() >= 3 && byte(0) == 0xed && byte(1) >= 0xa0 && (byte(2) & 0xc0U) == 0x80U ? 3 : 0;
}

/// Replaces what no JSON parser accepts in a string by U+FFFD.
std::string repaired(std::string_view text) {
    std::string out;
    out.reserve(text.size());
    const auto skip = [&](std::size_t bytes) {
        out += text.substr(0, bytes);
        text.remove_prefix(bytes);
    };
    while (!text.empty()) {
        if (text.front() == '\\') {
            const auto value = escapeAt(text, 0);
            const bool high = value && isSurrogate(*value, 0xd800);
            const auto low = high ? escapeAt(text, 6) : std::nullopt;
            if (low && isSurrogate(*low, 0xdc00)) {
                skip(12);
            } else if (high || (value && isSurrogate(*value, 0xdc00))) {
                out += "\\ufffd";
                text.remove_prefix(6);
            } else {
                skip(std::min<std::size_t>(2, text.size()));
            }
            continue;
        }
        const Utf8Character character = firstCharacter(text);
        if (character.valid) {
            skip(character.length);
            continue;
        }
        out += kReplacement;
        text.remove_prefix(std::max<std::size_t>(rawSurrogate(text), 1));
    }
    return out;
}

} // namespace

std::optional<nlohmann::json> parseLspMessage(std::string text) {
    if (!isWithinLimits(text))
        return {};
    auto parsed = nlohmann::json::parse(text, nullptr, false);
    if (parsed.is_discarded()) {
        text = repaired(text);
        parsed = nlohmann::json::parse(text, nullptr, false);
    }
    return parsed.is_discarded() ? std::nullopt : std::optional(std::move(parsed));
}

const nlohmann::json& objectIn(const nlohmann::json& object, const char* key) {
    if (!object.is_object() || !object.contains(key) || !object[key].is_object())
        throw InvalidParameter(std::string("There is no object ") + key + ".");
    return object[key];
}

const std::string& stringIn(const nlohmann::json& object, const char* key) {
    if (!object.is_object() || !object.contains(key) || !object[key].is_string())
        throw InvalidParameter(std::string("There is no text ") + key + ".");
    return object[key].get_ref<const std::string&>();
}

std::size_t indexIn(const nlohmann::json& object, const char* key) {
    if (!object.is_object() || !object.contains(key) || !object[key].is_number_unsigned())
        throw InvalidParameter(std::string("There is no whole number ") + key + ".");
    return static_cast<std::size_t>(
        std::min<std::uint64_t>(object[key].get<std::uint64_t>(), std::numeric_limits<std::int32_t>::max()));
}

} // namespace proveout::cli
