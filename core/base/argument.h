// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <utility>

namespace proveout {

/// What stands for a `{}` of a diagnostic: a word of the user's file, a key or text of the core, which stays
/// as it is (or is translated); or figures that the core has computed. Always written with a decimal point,
/// as files, JSON and the command line have it; a window writes figures as its language does.
class Argument {
public:
    Argument(std::string text) : m_text(std::move(text)) {}
    Argument(std::string_view text) : m_text(text) {}
    Argument(const char* text) : m_text(text) {}
    /// The letter of a word. No number becomes one by accident.
    template<std::same_as<char> Letter>
    Argument(Letter letter) : m_text(1, letter) {}

    /// Figures, with or without units: every point in them is a decimal point. See figures().
    [[nodiscard]] static Argument ofFigures(std::string text) {
        Argument argument(std::move(text));
        argument.m_isFigures = true;
        return argument;
    }

    [[nodiscard]] bool isFigures() const { return m_isFigures; }
    [[nodiscard]] const std::string& text() const { return m_text; }
    operator const std::string&() const { return m_text; }

    /// Whether they read the same where nobody translates.
    friend bool operator==(const Argument& a, const Argument& b) { return a.m_text == b.m_text; }

private:
    std::string m_text;
    bool m_isFigures = false;
};

} // namespace proveout
