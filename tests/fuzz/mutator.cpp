// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/mutator.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>

namespace proveout::test {

namespace {

using Words = std::span<const std::string>;

constexpr std::size_t kMostChanges = 10;
constexpr std::size_t kLongestPiece = 400; ///< of the piece that is copied, moved or removed
constexpr std::size_t kMostCopies = 2000;

constexpr std::array<std::string_view, 30> kNumbers{"0",
                                                    "-0",
                                                    "1",
                                                    "-1",
                                                    "1e308",
                                                    "-1e308",
                                                    "1e-308",
                                                    "1e39",
                                                    "nan",
                                                    "-nan",
                                                    "inf",
                                                    "-inf",
                                                    "1e999",
                                                    "0.1",
                                                    "1e7",
                                                    "1e-3",
                                                    "1e6",
                                                    "-1e6",
                                                    "2147483647",
                                                    "-2147483648",
                                                    "4294967295",
                                                    "4294967296",
                                                    "9223372036854775807",
                                                    "18446744073709551616",
                                                    "999999999",
                                                    "1e-9",
                                                    ".",
                                                    "1.5.5",
                                                    "0x1p3",
                                                    "00000000000000000000000000000000000001"};
constexpr std::array<std::string_view, 18> kSeparators{"\n", "\r", "\r\n", "\n\n", " ", "\t", ",", ";",  "=",
                                                       ":",  "(",  ")",    "[",    "]", "{",  "}", "\"", "#"};
constexpr std::array<float, 10> kFloats{0.0F,
                                        -0.0F,
                                        1e30F,
                                        -1e30F,
                                        1e6F,
                                        1e-40F,
                                        std::numeric_limits<float>::infinity(),
                                        std::numeric_limits<float>::quiet_NaN(),
                                        std::numeric_limits<float>::max(),
                                        1e-3F};
constexpr std::array<std::uint64_t, 8> kIntegers{
    0, 1, 0x7fffffff, 0x80000000, 0xffffffff, 0x100000000, 0x7fffffffffffffff, 0xffffffffffffffff};

std::size_t below(std::size_t bound, MutationRandom& random) {
    return bound == 0 ? 0 : static_cast<std::size_t>(random() % bound);
}

template<class Table>
const auto& anyOf(const Table& table, MutationRandom& random) {
    return table[below(table.size(), random)];
}

struct Piece {
    std::size_t at = 0;
    std::size_t length = 0;
};

Piece anyPiece(const std::string& bytes, MutationRandom& random) {
    const std::size_t at = below(bytes.size(), random);
    return {at, below(std::min(kLongestPiece, bytes.size() - at) + 1, random)};
}

template<class IsPart>
Piece around(const std::string& bytes, std::size_t from, const IsPart& isPart) {
    const auto first = std::find_if(bytes.begin() + static_cast<std::ptrdiff_t>(from), bytes.end(), isPart);
    const auto last = std::find_if_not(first, bytes.end(), isPart);
    return {static_cast<std::size_t>(first - bytes.begin()), static_cast<std::size_t>(last - first)};
}

Piece anyNumber(const std::string& bytes, MutationRandom& random) {
    return around(bytes, below(bytes.size(), random),
                  [](char c) { return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+'; });
}

Piece anyWord(const std::string& bytes, MutationRandom& random) {
    return around(bytes, below(bytes.size(), random), [](char c) {
        return std::string_view(" \t\r\n,;=:()[]{}").find(c) == std::string_view::npos;
    });
}

Piece anyLine(const std::string& bytes, MutationRandom& random) {
    Piece line = around(bytes, below(bytes.size(), random), [](char c) { return c != '\n' && c != '\r'; });
    line.length = std::min(line.length + 1, bytes.size() - line.at); // includes the line end
    return line;
}

void insert(std::string& bytes, std::string_view what, MutationRandom& random) {
    bytes.insert(below(bytes.size() + 1, random), what);
}

template<class Value>
void overwrite(std::string& bytes, const Value& value, std::size_t size, MutationRandom& random) {
    size = std::min(size, bytes.size());
    std::memcpy(bytes.data() + below(bytes.size() - size + 1, random), &value, size);
}

void copyPiece(std::string& bytes, const Piece& piece, MutationRandom& random) {
    insert(bytes, std::string(bytes, piece.at, piece.length), random);
}

void repeatPiece(std::string& bytes, const Piece& piece, MutationRandom& random) {
    const std::string copied(bytes, piece.at, piece.length);
    const std::size_t room = bytes.size() < kLargestInput ? kLargestInput - bytes.size() : 0;
    std::size_t copies = below(std::size_t{1} << below(12, random), random);
    copies = std::min({copies, kMostCopies, room / std::max<std::size_t>(copied.size(), 1)});
    std::string repeated;
    while (copies-- > 0)
        repeated += copied;
    bytes.insert(piece.at, repeated);
}

using Change = void (*)(std::string& bytes, Words words, MutationRandom& random);

/// One row per kind of damage; `bytes` must not be empty.
constexpr std::array<Change, 20> kChanges{
    [](std::string& bytes, Words, MutationRandom& random) { // flips a bit
        char& byte = bytes[below(bytes.size(), random)];
        byte = static_cast<char>(byte ^ (1 << below(8, random)));
    },
    [](std::string& bytes, Words, MutationRandom& random) { // changes a byte
        bytes[below(bytes.size(), random)] = static_cast<char>(random());
    },
    [](std::string& bytes, Words, MutationRandom& random) {
        const std::size_t at = below(bytes.size() + 1, random);
        bytes.insert(at, 1, static_cast<char>(random()));
    },
    [](std::string& bytes, Words, MutationRandom& random) { bytes.erase(below(bytes.size(), random), 1); },
    [](std::string& bytes, Words, MutationRandom& random) { bytes.resize(below(bytes.size(), random)); },
    [](std::string& bytes, Words, MutationRandom& random) {
        const Piece piece = anyPiece(bytes, random);
        bytes.erase(piece.at, piece.length);
    },
    [](std::string& bytes, Words, MutationRandom& random) {
        copyPiece(bytes, anyPiece(bytes, random), random);
    },
    [](std::string& bytes, Words, MutationRandom& random) { // moves a piece
        const Piece piece = anyPiece(bytes, random);
        const std::string moved(bytes, piece.at, piece.length);
        bytes.erase(piece.at, piece.length);
        insert(bytes, moved, random);
    },
    [](std::string& bytes, Words, MutationRandom& random) {
        repeatPiece(bytes, anyPiece(bytes, random), random);
    },
    [](std::string& bytes, Words, MutationRandom& random) {
        repeatPiece(bytes, anyWord(bytes, random), random);
    },
    [](std::string& bytes, Words, MutationRandom& random) {
        repeatPiece(bytes, anyLine(bytes, random), random);
    },
    [](std::string& bytes, Words, MutationRandom& random) {
        const Piece number = anyNumber(bytes, random);
        bytes.replace(number.at, number.length, anyOf(kNumbers, random));
    },
    [](std::string& bytes, Words, MutationRandom& random) { // another part of the file
        const Piece from = anyNumber(bytes, random);
        const std::string copied(bytes, from.at, from.length);
        const Piece to = anyNumber(bytes, random);
        bytes.replace(to.at, to.length, copied);
    },
    [](std::string& bytes, Words, MutationRandom& random) {
        copyPiece(bytes, anyWord(bytes, random), random);
    },
    [](std::string& bytes, Words, MutationRandom& random) {
        copyPiece(bytes, anyLine(bytes, random), random);
    },
    [](std::string& bytes, Words, MutationRandom& random) {
        const Piece line = anyLine(bytes, random);
        bytes.erase(line.at, line.length);
    },
    [](std::string& bytes, Words, MutationRandom& random) {
        insert(bytes, anyOf(kSeparators, random), random);
    },
    [](std::string& bytes, Words words, MutationRandom& random) {
        if (!words.empty())
            insert(bytes, anyOf(words, random), random);
    },
    [](std::string& bytes, Words, MutationRandom& random) {
        const float value = anyOf(kFloats, random);
        overwrite(bytes, value, sizeof value, random);
    },
    [](std::string& bytes, Words, MutationRandom& random) {
        const std::uint64_t value = anyOf(kIntegers, random);
        overwrite(bytes, value, std::size_t{1} << below(4, random), random);
    },
};

} // namespace

std::string mutated(std::string seed, std::span<const std::string> words, MutationRandom& random) {
    // Rarely many changes, because a file that is refused at its first byte tests nothing.
    for (std::size_t left = below(1 + below(kMostChanges, random), random); left > 0 && !seed.empty(); --left)
        anyOf(kChanges, random)(seed, words, random);
    if (seed.size() > kLargestInput)
        seed.resize(kLargestInput);
    return seed;
}

} // namespace proveout::test
