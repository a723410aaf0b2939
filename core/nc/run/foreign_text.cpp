// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/run/foreign_text.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/list_argument.h"
#include "core/base/text.h"
#include "core/nc/codes/dialect_guess.h"
#include "core/nc/codes/dialects.h"
#include "core/nc/program/reporter.h"
#include "core/nc/run/foreign_signs.h"
#include "core/nc/text/characters.h"
#include "core/nc/text/glob.h"

namespace proveout {

namespace {

constexpr std::size_t kMostLines = 2'000;
constexpr std::size_t kMostLinesOfLathe = 100'000;
constexpr std::size_t kLongestShown = 32;

/// Upper case, blanks as described in LineForm.
void trim(std::string_view line, std::string& out) {
    out.clear();
    for (const char c : line) {
        if (!isBlank(c))
            out.push_back(upperCase(c));
        else if (!out.empty() && out.back() != ' ')
            out.push_back(' ');
    }
    if (!out.empty() && out.back() == ' ')
        out.pop_back();
}

/// Whether "(" at `at` follows a name of two letters or more, as in CYCLE81(…), so that it is not a comment.
bool opensArguments(std::string_view line, std::size_t at) {
    std::size_t begin = at;
    while (begin > 0 && isDigit(line[begin - 1]))
        --begin;
    return begin >= 2 && isCapital(line[begin - 1]) && isCapital(line[begin - 2]);
}

std::size_t behindNumber(std::string_view line) {
    std::size_t at = line.starts_with('/') ? 1 : 0;
    const std::size_t letter = at < line.size() && line[at] == 'N' ? 1 : 0;
    std::size_t end = at + letter;
    while (end < line.size() && isDigit(line[end]))
        ++end;
    if (end == at + letter || (letter == 0 && (end >= line.size() || line[end] != ' ')))
        return at;
    return end < line.size() && line[end] == ' ' ? end + 1 : end;
}

void removeComments(std::string_view line, std::string& out) {
    out.clear();
    bool comment = false;
    bool arguments = false;
    for (std::size_t i = behindNumber(line); i < line.size(); ++i) {
        const char c = line[i];
        if (c == ';' && !comment)
            break;
        if (c == '(' && !comment && !arguments) {
            arguments = opensArguments(line, i);
            comment = !arguments;
        }
        if (!comment)
            out.push_back(c);
        arguments = arguments && c != ')';
        comment = comment && c != ')';
    }
    while (!out.empty() && out.back() == ' ')
        out.pop_back();
}

/// The forms of one line.
struct Forms {
    std::string line;
    std::string block;
    std::string squeezed;

    void set(std::string_view text) {
        constexpr std::size_t kLongest = 2'000;
        trim(text.substr(0, kLongest), line);
        removeComments(line, block);
        squeezed = block;
        std::erase(squeezed, ' ');
    }
    [[nodiscard]] const std::string& of(LineForm form) const {
        return form == LineForm::block ? block : form == LineForm::squeezed ? squeezed : line;
    }
};

/// The signs that were found of every kind.
class Evidence {
public:
    void look(const Forms& forms, bool first, std::string_view text, int line) {
        for (std::size_t i = 0; i < m_seen.size(); ++i) {
            const ForeignSign& sign = foreignSigns()[i];
            const std::string& form = forms.of(sign.form);
            if (m_seen[i] || form.empty() || (sign.form == LineForm::first && !first) ||
                !matchesGlob(sign.pattern, form))
                continue;
            m_seen[i] = true;
            Found& found = m_found[static_cast<std::size_t>(sign.kind)];
            if (sign.weight > found.heaviest) {
                found.heaviest = sign.weight;
                found.line = line;
                found.sign = text;
            }
            found.weight += sign.weight;
        }
    }

    struct Found {
        int weight = 0;
        int heaviest = 0;
        int line = 1;
        std::string sign;
    };
    [[nodiscard]] const Found& of(ForeignKind kind) const { return m_found[static_cast<std::size_t>(kind)]; }
    void forget(ForeignKind kind) { m_found[static_cast<std::size_t>(kind)] = {}; }
    /// The first of the heaviest kinds, nothing if none decides.
    [[nodiscard]] std::optional<ForeignKind> decided() const {
        const auto most = std::ranges::max_element(m_found, {}, &Found::weight);
        if (most->weight < kForeignDecides)
            return {};
        return static_cast<ForeignKind>(most - m_found.begin());
    }

private:
    std::vector<bool> m_seen = std::vector<bool>(foreignSigns().size());
    std::array<Found, kForeignKinds> m_found;
};

/// A block that a lathe program does not have: it names Y, or changes the tool as on a mill.
bool isOfMill(std::string_view squeezed) {
    for (std::size_t i = 0; i < squeezed.size(); ++i) {
        const bool number = i + 1 < squeezed.size() && !isCapital(squeezed[i + 1]);
        if (squeezed[i] == 'Y' && number)
            return true;
        if (squeezed.substr(i).starts_with("M6") || squeezed.substr(i).starts_with("M06"))
            return true;
    }
    return false;
}

/// LinuxCNC also runs lathes, and Fanuc's G50, G92 and S have other meanings on a mill.
bool isLathe(const NcText& text) {
    Forms forms;
    const std::size_t most = std::min(text.lineCount(), kMostLinesOfLathe);
    for (std::size_t i = 0; i < most; ++i) {
        forms.set(text.line(i));
        if (isOfMill(forms.squeezed))
            return false;
    }
    const DialectGuess guess = guessDialect(text);
    return guess.dialect != DialectId::linuxcnc || guess.reasons.empty();
}

std::string shown(std::string_view line) {
    std::string text;
    for (const char c : line.substr(0, kLongestShown))
        text.push_back(static_cast<unsigned char>(c) < ' ' ? ' ' : c);
    const std::size_t begin = std::min(text.find_first_not_of(' '), text.size());
    const std::size_t end = text.find_last_not_of(' ');
    return end == std::string::npos ? std::string() : text.substr(begin, end + 1 - begin);
}

std::string dialectNames() {
    std::vector<std::string> names;
    for (const Dialect& row : dialects())
        names.emplace_back(row.name);
    return listArgument(names);
}

} // namespace

std::optional<ForeignText> findForeignText(const NcText& text) {
    Evidence evidence;
    Forms forms;
    bool first = true;
    const std::size_t most = std::min(text.lineCount(), kMostLines);
    for (std::size_t i = 0; i < most; ++i) {
        forms.set(text.line(i));
        if (forms.line.empty())
            continue;
        evidence.look(forms, first, text.line(i), static_cast<int>(i + 1));
        first = false;
    }
    if (evidence.of(ForeignKind::lathe).weight >= kForeignDecides && !isLathe(text))
        evidence.forget(ForeignKind::lathe);
    const auto kind = evidence.decided();
    if (!kind)
        return {};
    const ForeignKindRow& row = rowOf(*kind);
    const Evidence::Found& found = evidence.of(*kind);
    return ForeignText{row.name, row.program ? &nc_message::kDialectForeign : &nc_message::kNotAProgram,
                       shown(found.sign), found.line};
}

std::shared_ptr<const Program> foreignProgram(const NcText& text, const InterpretOptions& options) {
    const auto foreign = options.dialect ? std::nullopt : findForeignText(text);
    if (!foreign)
        return nullptr;
    auto program = std::make_shared<Program>();
    program->setForeignKind(foreign->kind);
    if (options.watchedLine > 0) {
        LineValues nothing;
        nothing.line = options.watchedLine;
        program->setLineValues(std::make_shared<const LineValues>(std::move(nothing)));
    }
    Reporter reporter(*program, options.file, options.maxDiagnostics);
    reporter.beginLine(static_cast<std::uint32_t>(foreign->line));
    reporter.report(*foreign->message, 1, 0,
                    {foreign->kind, std::to_string(foreign->line), foreign->sign, dialectNames()});
    return program;
}

} // namespace proveout
