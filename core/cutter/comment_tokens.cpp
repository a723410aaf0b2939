// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutter/comment_tokens.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "core/base/utf8.h"

namespace proveout {

namespace {

constexpr std::size_t kMostBytes = 256;
constexpr std::size_t kMostTokens = 64;
constexpr std::size_t kMostDigits = 12;

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

/// Upper case of the Latin and Cyrillic letters that tool names are written in; 0: not a letter.
char32_t foldedLetter(char32_t code) {
    if (code >= 'a' && code <= 'z')
        return code - 0x20;
    if (code >= 'A' && code <= 'Z')
        return code;
    if (code == 0xD7 || code == 0xF7) // signs in the range of the letters
        return 0;
    if (code >= 0xE0 && code <= 0xFE)
        return code - 0x20;
    if (code >= 0x430 && code <= 0x44F)
        return code - 0x20;
    return code >= 0xC0 ? code : 0;
}

bool isDiameterSign(char32_t code) {
    return code == 0xD8 || code == 0xF8 || code == 0x2300 || code == 0x2205 || code == 0x3C6 || code == 0x3A6;
}

bool isDegreeSign(char32_t code) {
    return code == 0xB0 || code == 0xBA;
}

void appendUtf8(std::string& out, char32_t code) {
    if (code < 0x80) {
        out.push_back(static_cast<char>(code));
    } else if (code < 0x800) {
        out.push_back(static_cast<char>(0xC0 | code >> 6));
        out.push_back(static_cast<char>(0x80 | (code & 0x3F)));
    } else if (code < 0x10000) {
        out.push_back(static_cast<char>(0xE0 | code >> 12));
        out.push_back(static_cast<char>(0x80 | (code >> 6 & 0x3F)));
        out.push_back(static_cast<char>(0x80 | (code & 0x3F)));
    }
}

/// Reads a comment from left to right.
class Tokenizer {
public:
    explicit Tokenizer(std::string_view comment) : m_rest(comment.substr(0, kMostBytes)) {}

    std::vector<CommentToken> run() {
        while (!m_rest.empty() && m_tokens.size() < kMostTokens)
            step();
        return std::move(m_tokens);
    }

private:
    void step() {
        if (m_rest[0] == '$' || m_rest[0] == '#')
            return skipVariable();
        if (startsNumber())
            return readNumber();
        const Utf8Character next = firstCharacter(m_rest);
        if (isDiameterSign(next.code))
            return readDiameterSign(next);
        if (foldedLetter(next.code) != 0)
            return readWord();
        readSign(next);
    }

    [[nodiscard]] bool startsNumber() const {
        return isDigit(m_rest[0]) || (m_rest[0] == '.' && m_rest.size() > 1 && isDigit(m_rest[1]));
    }

    void add(CommentToken token) {
        token.separated = std::exchange(m_separated, false);
        token.equals = std::exchange(m_equals, false);
        token.minus = std::exchange(m_minus, false);
        token.term = std::exchange(m_term, false);
        m_tokens.push_back(std::move(token));
    }

    /// "$TOOL1" and "#12". The sign alone is treated like any other sign: "TOOL #1".
    void skipVariable() {
        if (m_rest[0] == '#' && !m_tokens.empty() && !m_tokens.back().isNumber())
            return readSign(firstCharacter(m_rest));
        const auto isPart = [](char c) {
            return isDigit(c) || c == '_' || foldedLetter(static_cast<unsigned char>(c)) != 0;
        };
        std::size_t end = 1;
        while (end < m_rest.size() && isPart(m_rest[end]))
            ++end;
        m_rest.remove_prefix(end);
        m_separated = true;
        m_term = true;
    }

    void readDiameterSign(const Utf8Character& sign) {
        m_rest.remove_prefix(sign.length);
        CommentToken token;
        token.word = "Ø";
        add(std::move(token));
    }

    void readWord() {
        CommentToken token;
        while (!m_rest.empty()) {
            const Utf8Character next = firstCharacter(m_rest);
            const char32_t letter = isDiameterSign(next.code) ? 0 : foldedLetter(next.code);
            if (letter == 0)
                break;
            appendUtf8(token.word, letter);
            m_rest.remove_prefix(next.length);
        }
        const bool follows = !m_tokens.empty() && m_tokens.back().isNumber() && !m_equals;
        const CommentUnit unit = follows ? unitAt(token.word) : CommentUnit::none;
        if (unit != CommentUnit::none && m_tokens.back().unit == CommentUnit::none) {
            m_tokens.back().unit = unit;
            m_separated = false;
            m_minus = false;
            return;
        }
        if (follows && !m_separated)
            m_tokens.back().glued = true;
        add(std::move(token));
    }

    /// "in" is a unit and also an English word: when separated from its number, it is a unit only at the end
    /// of a phrase.
    [[nodiscard]] CommentUnit unitAt(std::string_view word) const {
        const bool phraseContinues =
            m_rest.size() > 1 && m_rest[0] == ' ' && foldedLetter(static_cast<unsigned char>(m_rest[1])) != 0;
        return word == "IN" && m_separated && phraseContinues ? CommentUnit::none : unitNamed(word);
    }

    void readSign(const Utf8Character& sign) {
        const bool afterNumber = !m_tokens.empty() && m_tokens.back().isNumber() && !m_separated && !m_equals;
        m_rest.remove_prefix(sign.length);
        if (afterNumber && isDegreeSign(sign.code)) {
            m_tokens.back().unit = CommentUnit::degree;
        } else if (afterNumber && (sign.code == '"' || (sign.code == '\'' && m_rest.starts_with('\'')))) {
            m_tokens.back().unit = CommentUnit::inch;
        } else {
            const bool operation = sign.code == '+' || sign.code == '*';
            m_term = m_term || operation;
            if (operation && !m_separated && !m_tokens.empty() && m_tokens.back().isNumber())
                m_tokens.back().term = true;
            m_separated = true;
            m_equals = m_equals || sign.code == '=' || sign.code == ':';
            m_minus = sign.code == '-';
        }
    }

    /// The digits of a number, with a decimal comma if it has only one.
    std::string readDigits(bool& point) {
        std::string digits;
        std::size_t at = 0;
        for (; at < m_rest.size(); ++at) {
            const bool mark = m_rest[at] == '.' || m_rest[at] == ',';
            if (isDigit(m_rest[at]))
                digits.push_back(m_rest[at]);
            else if (mark && !point && (m_rest[at] == '.' || isDecimalComma(at)))
                digits.push_back('.');
            else
                break;
            point = point || mark;
        }
        m_rest.remove_prefix(at);
        return digits;
    }

    /// One to three digits follow, and no further mark; otherwise the comma separates the items of a list.
    [[nodiscard]] bool isDecimalComma(std::size_t at) const {
        std::size_t end = at + 1;
        while (end < m_rest.size() && isDigit(m_rest[end]))
            ++end;
        const bool mark = end < m_rest.size() && (m_rest[end] == '.' || m_rest[end] == ',');
        return end > at + 1 && end <= at + 4 && !mark;
    }

    void readNumber() {
        CommentToken token;
        const std::string digits = readDigits(token.point);
        if (digits.size() > kMostDigits ||
            std::from_chars(digits.data(), digits.data() + digits.size(), token.value).ec != std::errc())
            token.value = std::nan("");
        if (!token.point)
            readFraction(token);
        add(std::move(token));
    }

    /// "1/4", and the rest of "1-1/2" or "1 1/2". Inches are divided into powers of two.
    void readFraction(CommentToken& token) {
        std::string_view rest = m_rest;
        std::optional<double> whole;
        double numerator = token.value;
        if (!followsNumberLabel() && rest.size() > 1 && (rest[0] == '-' || rest[0] == ' ') &&
            isDigit(rest[1])) {
            whole = token.value;
            rest.remove_prefix(1);
            numerator = readWhole(rest);
        }
        if (rest.size() < 2 || rest[0] != '/' || !isDigit(rest[1]))
            return;
        rest.remove_prefix(1);
        const double denominator = readWhole(rest);
        constexpr double kDenominators[] = {2, 4, 8, 16, 32, 64, 128};
        if (std::ranges::find(kDenominators, denominator) == std::end(kDenominators) ||
            numerator >= denominator * (whole ? 1 : 16))
            return;
        token.value = whole.value_or(0) + numerator / denominator;
        token.fraction = true;
        m_rest = rest;
    }

    /// In "T2 3/8" the 2 is not part of the fraction.
    [[nodiscard]] bool followsNumberLabel() const {
        static constexpr std::string_view kNumberLabels[] = {"T", "TOOL", "NO", "NR", "NUMBER", "H", "D"};
        return !m_tokens.empty() &&
               std::ranges::find(kNumberLabels, m_tokens.back().word) != std::end(kNumberLabels);
    }

    static double readWhole(std::string_view& text) {
        double value = 0;
        const auto [end, error] = std::from_chars(
            text.data(), text.data() + std::min(text.size(), kMostDigits), value, std::chars_format::fixed);
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
        return error == std::errc() ? value : 0;
    }

    std::string_view m_rest;
    std::vector<CommentToken> m_tokens;
    bool m_separated = false;
    bool m_equals = false;
    bool m_minus = false;
    bool m_term = false; ///< the number that follows is a term of an expression, not a size
};

} // namespace

CommentUnit unitNamed(std::string_view word) {
    struct Row {
        std::string_view word;
        CommentUnit unit;
    };
    static constexpr Row kRows[] = {
        {"MM", CommentUnit::mm},         {"MILLIMETER", CommentUnit::mm},  {"MILLIMETERS", CommentUnit::mm},
        {"MILLIMETRE", CommentUnit::mm}, {"MILLIMETRES", CommentUnit::mm}, {"METRIC", CommentUnit::mm},
        {"IN", CommentUnit::inch},       {"INCH", CommentUnit::inch},      {"INCHES", CommentUnit::inch},
        {"ZOLL", CommentUnit::inch},     {"IMPERIAL", CommentUnit::inch},  {"DEG", CommentUnit::degree},
        {"DEGREE", CommentUnit::degree}, {"DEGREES", CommentUnit::degree}, {"GRAD", CommentUnit::degree},
    };
    const auto* const found = std::ranges::find(kRows, word, &Row::word);
    return found == std::end(kRows) ? CommentUnit::none : found->unit;
}

std::vector<CommentToken> commentTokens(std::string_view comment) {
    return Tokenizer(comment).run();
}

} // namespace proveout
