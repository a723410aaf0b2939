// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/nc/random_rare_blocks.h"

#include <fmt/format.h>

namespace proveout::test {

namespace {

using Lines = std::vector<std::string>;

std::string word(char letter, const std::string& number) {
    return letter + number;
}

/// Some of X, Y and Z, at least one.
std::vector<std::string> axisWords(RandomWords& words, double far) {
    std::vector<std::string> result;
    for (const char letter : {'X', 'Y', 'Z'}) {
        if (words.once(2) || (letter == 'Z' && result.empty()))
            result.push_back(word(letter, words.number(-far, far)));
    }
    return result;
}

/// A straight motion must follow a spline, because the listing does not contain the end of the spline.
Lines nurbs(RandomWords& words) {
    constexpr double kFar = 20;
    const auto point = [&](Lines block) {
        block.push_back(word('X', words.number(-kFar, kFar)));
        block.push_back(word('Y', words.number(-kFar, kFar)));
        if (!words.once(12))
            block.push_back(word('P', words.number(1, 2)));
        return words.block(block);
    };
    Lines first{"G5.2"};
    if (words.once(2))
        first.push_back(fmt::format("L{}", words.between(2, 4)));
    Lines lines{"G17", point(first)};
    for (int more = words.between(1, 4); more > 0; --more)
        lines.push_back(point({}));
    if (!words.once(12))
        lines.emplace_back("G5.3");
    lines.emplace_back("G1 Z1");
    return lines;
}

Lines probing(RandomWords& words) {
    constexpr double kFar = 20;
    Lines block = axisWords(words, kFar);
    block.push_back(words.oneOf({"G38.2", "G38.3", "G38.4", "G38.5"}));
    Lines lines{words.block(block)};
    if (words.once(3))
        lines.push_back(words.block(axisWords(words, kFar)));
    return lines;
}

Lines latheCycle(RandomWords& words) {
    if (words.once(2))
        return {words.block({"G76", word('P', words.number(1, 2)), word('Z', words.number(-9, -1)),
                             word('I', words.number(-3, -1)), word('J', words.number(0.1, 1)),
                             word('K', words.number(1, 2))})};
    return {words.block({words.oneOf({"G70", "G71", "G71.1", "G72", "G72.2"}), "Q1", "D1"})};
}

Lines diameters(RandomWords& words) {
    Lines block = axisWords(words, 9);
    block.emplace_back("G7");
    return {words.block(block), "G8"};
}

Lines otherPlanes(RandomWords& words) {
    return {words.oneOf({"G17.1", "G18.1", "G19.1"}), words.block(axisWords(words, 9)), "G17"};
}

Lines inputs(RandomWords& words) {
    Lines block{"M66", words.oneOf({"P0", "P1", "E0", "E1"})};
    if (words.once(2))
        block.push_back(fmt::format("L{}", words.between(0, 4)));
    if (words.once(2))
        block.push_back(fmt::format("Q{}", words.between(0, 2)));
    Lines lines{words.block(block)};
    if (words.once(4))
        lines.emplace_back("G1 X#5399 F100");
    return lines;
}

} // namespace

Lines randomRareBlocks(RandomWords& words) {
    using Kind = Lines (*)(RandomWords&);
    static const std::vector<Kind> kKinds{nurbs, probing, latheCycle, diameters, otherPlanes, inputs};
    return words.oneOf(kKinds)(words);
}

} // namespace proveout::test
