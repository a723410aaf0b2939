// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <utility>

namespace proveout {

/// An argument of a diagnostic, which replaces a `{}` of its text: either text (a word of the user's file, or
/// a key or text of the core, kept as it is or translated) or figures that the core has computed. Figures
/// always use a decimal point, as files, JSON and the command line do; a window writes them as its language
/// does.
class Argument {
public:
    Argument(std::string text) : m_text(std::move(text)) {}
    Argument(std::string_view text) : m_text(text) {}
    Argument(const char* text) : m_text(text) {}
    /// The letter of a word. Only a char converts, so that no number becomes a letter by accident.
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

    /// Compares the untranslated English texts.
    friend bool operator==(const Argument& a, const Argument& b) { return a.m_text == b.m_text; }

private:
    std::string m_text;
    bool m_isFigures = false;
};

} // namespace proveout
