// SPDX-License-Identifier: GPL-3.0-or-later
// Random numbers and expressions of LinuxCNC's language.
#pragma once

#include <initializer_list>
#include <random>
#include <string>
#include <vector>

namespace proveout::test {

/// Generates random parts of a program. Equal seeds give equal parts.
class RandomWords {
public:
    explicit RandomWords(std::mt19937& random) : m_random(random) {}

    [[nodiscard]] int between(int least, int most);
    /// True with a probability of 1 / `n`.
    [[nodiscard]] bool once(int n) { return between(1, n) == 1; }
    template<class T>
    [[nodiscard]] const T& oneOf(const std::vector<T>& all) {
        return all[static_cast<std::size_t>(between(0, static_cast<int>(all.size()) - 1))];
    }
    [[nodiscard]] std::string oneOf(std::initializer_list<const char*> all) {
        return all.begin()[between(0, static_cast<int>(all.size()) - 1)];
    }

    /// A plain number within the limits, in any valid notation.
    [[nodiscard]] std::string number(double least, double most);
    /// A number, a parameter or an expression, with a value suitable for a coordinate.
    [[nodiscard]] std::string length();
    /// "[…]", of any size.
    [[nodiscard]] std::string expression(int depth = 2);
    /// "#…" for a parameter that can be read.
    [[nodiscard]] std::string parameter();
    /// "#…" for a parameter that a program may set.
    [[nodiscard]] std::string target();
    /// The words in random sequence, joined in any valid way.
    [[nodiscard]] std::string block(std::vector<std::string> words);

private:
    [[nodiscard]] std::string operand(int depth);

    std::mt19937& m_random;
};

} // namespace proveout::test
