// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace proveout {

/// A letter with its number, and its place in the line (columns are 1-based and count bytes).
struct Word {
    char letter = 0; ///< upper case; "@" and "^" are the radius and the angle of a polar end point
    double value = 0;
    int column = 0;
    int length = 0;
    bool point = true; ///< whether the number is in whole units: it has a decimal point or was computed
};

/// Represent ",C" and ",R" of Fanuc's dialect, which are words of their own.
inline constexpr char kChamferLetter = '[';
inline constexpr char kRoundingLetter = ']';
/// Represents "$", with which LinuxCNC selects a spindle.
inline constexpr char kSpindleLetter = '_';

/// A set of letters of words.
class LetterSet {
public:
    constexpr LetterSet() = default;
    constexpr explicit LetterSet(const char* letters) {
        for (; *letters != '\0'; ++letters)
            add(*letters);
    }
    constexpr void add(char letter) { m_bits |= bit(letter); }
    constexpr void add(LetterSet other) { m_bits |= other.m_bits; }
    constexpr void remove(LetterSet other) { m_bits &= ~other.m_bits; }
    [[nodiscard]] constexpr bool has(char letter) const { return (m_bits & bit(letter)) != 0; }
    [[nodiscard]] constexpr bool any(LetterSet other) const { return (m_bits & other.m_bits) != 0; }
    [[nodiscard]] constexpr bool empty() const { return m_bits == 0; }

private:
    static constexpr std::uint32_t bit(char letter) { return 1U << static_cast<unsigned>(letter - '@'); }

    std::uint32_t m_bits = 0;
};
inline constexpr LetterSet kAxisWords("XYZ");

/// The words of one line: G and M words in the order of the text, every other letter with one value. One
/// object is filled again and again.
class Block {
public:
    static constexpr std::size_t kMostCodes = 24;

    void clear() {
        m_letters = {};
        m_called.clear();
        m_codeCount = 0;
        m_ignoredCodes = 0;
        m_earlier.clear();
    }
    /// False if the word cannot be added: the letter exists already, or there are too many codes.
    [[nodiscard]] bool add(const Word& word) {
        if (word.letter == 'G' || word.letter == 'M') {
            if (m_codeCount == kMostCodes)
                return false;
            m_codes[m_codeCount++] = word;
            return true;
        }
        if (m_letters.has(word.letter))
            return false;
        m_letters.add(word.letter);
        m_words[index(word.letter)] = word;
        return true;
    }

    /// Like add(), but a letter that exists already gets the new value.
    [[nodiscard]] bool addOrReplace(const Word& word) {
        if (add(word))
            return true;
        if (!m_letters.has(word.letter))
            return false;
        m_earlier.push_back(m_words[index(word.letter)]);
        m_words[index(word.letter)] = word;
        return true;
    }

    [[nodiscard]] bool has(char letter) const { return m_letters.has(letter); }
    [[nodiscard]] const Word& word(char letter) const { return m_words[index(letter)]; }
    [[nodiscard]] double value(char letter) const { return m_words[index(letter)].value; }
    [[nodiscard]] LetterSet letters() const { return m_letters; } ///< without G and M
    [[nodiscard]] std::span<const Word> codes() const { return {m_codes.data(), m_codeCount}; }
    /// Removes the code at `index` of codes(); words beside it may belong to it.
    void ignoreCode(std::size_t index) {
        for (std::size_t i = index + 1; i < m_codeCount; ++i)
            m_codes[i - 1] = m_codes[i];
        --m_codeCount;
        ++m_ignoredCodes;
    }
    [[nodiscard]] int ignoredCodes() const { return m_ignoredCodes; } ///< number of removed codes
    /// Words whose letter occurred again later, in the order of the text.
    [[nodiscard]] std::span<const Word> earlier() const { return m_earlier; }
    /// The name between < and > of the program that the block calls; empty if it gives none.
    [[nodiscard]] const std::string& called() const { return m_called; }
    void setCalled(std::string_view name) { m_called = name; }
    [[nodiscard]] bool empty() const { return m_letters.empty() && m_codeCount == 0; }

private:
    static std::size_t index(char letter) { return static_cast<std::size_t>(letter - '@'); }

    static constexpr std::size_t kLetters = '_' - '@' + 1;

    LetterSet m_letters;
    std::string m_called;
    std::size_t m_codeCount = 0;
    int m_ignoredCodes = 0;
    std::array<Word, kLetters> m_words;
    std::array<Word, kMostCodes> m_codes;
    std::vector<Word> m_earlier;
};

} // namespace proveout
