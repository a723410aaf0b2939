// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/codes/dialect_guess.h"

#include "core/nc/codes/dialects.h"
#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "core/nc/text/characters.h"
#include "core/nc/text/named_control.h"

namespace proveout {

namespace {

constexpr std::size_t kMostLines = 100'000;
constexpr std::size_t kMostOfHeading = 100; ///< lines whose comments may name the post processor
constexpr std::size_t kLongestShown = 24;

constexpr int kHint = 1;      ///< other controls may use it too
constexpr int kSign = 4;      ///< has another meaning, or none, on other controls
constexpr int kNamed = 20;    ///< a comment names the post processor or the control
constexpr int kDecides = 100; ///< no other control accepts it

/// A piece of a line without blanks and comments, in upper case: "*" matches anything, "#" a digit, "?" a
/// letter. A pattern that begins with "^" matches at the beginning of the line, after N.
struct Row {
    DialectId dialect;
    int weight;
    std::string_view pattern;
};

using enum DialectId;

constexpr Row kSignRows[] = {
    {linuxcnc, kDecides, "^O<"},
    {linuxcnc, kDecides, "#<"},
    {linuxcnc, kDecides, "EXISTS["},
    {linuxcnc, kDecides, "^O%SUB"},
    {linuxcnc, kDecides, "^O%CALL"},
    {linuxcnc, kDecides, "^O%IF["},
    {linuxcnc, kDecides, "^O%WHILE["},
    {linuxcnc, kDecides, "^O%REPEAT["},
    {linuxcnc, kDecides, "^O%DO"},
    {linuxcnc, kDecides, "**"},
    {linuxcnc, kSign, "G90.1"},
    {linuxcnc, kSign, "G91.1"},
    {linuxcnc, kSign, "G43.1"},
    {linuxcnc, kSign, "G43.2"},
    {linuxcnc, kSign, "G61.1"},
    {linuxcnc, kSign, "G64P"},
    {linuxcnc, kSign, "G33.1"},
    {linuxcnc, kSign, "G38.2"},
    {linuxcnc, kSign, "G38.3"},
    {linuxcnc, kSign, "G59.1"},
    {linuxcnc, kSign, "G59.2"},
    {linuxcnc, kSign, "G59.3"},
    {linuxcnc, kSign, "G92.2"},
    {linuxcnc, kSign, "M61Q"},
    {fanuc, kDecides, "]GOTO"},
    {fanuc, kDecides, "^GOTO"},
    {fanuc, kDecides, "]THEN"},
    {fanuc, kDecides, "^WHILE["},
    {fanuc, kDecides, "^IF["},
    {fanuc, kDecides, "G65P"},
    {fanuc, kDecides, "G66P"},
    {fanuc, kSign, "G54.1P"},
    {fanuc, kSign, "G68X"},
    {fanuc, kSign, "G68R"},
    {fanuc, kSign, "G50.1"},
    {fanuc, kSign, "G51.1"},
    {fanuc, kSign, "G51X"},
    {fanuc, kSign, "G51P"},
    {fanuc, kSign, "G5.1Q"},
    {fanuc, kSign, "G05.1Q"},
    {fanuc, kSign, "G4X"},
    {fanuc, kSign, "G04X"},
    {fanuc, kSign, "M29S"},
    {fanuc, kSign, "G10L10P"},
    {fanuc, kSign, "G10L12P"},
    {fanuc, kSign, "G10L13P"},
    {fanuc, kHint, "^O####"},
    {fanuc, kHint, "^:####"},
    {fanuc, kHint, "^<"},
    {fanuc, kHint, "^M99"},
    {haas, kDecides, "G154P"},
    {haas, kDecides, "G187"},
    {haas, kDecides, "G150"},
    {haas, kDecides, "M97P"},
    {haas, kSign, "G47E"},
    {haas, kSign, "G100"},
    {haas, kSign, "G110"},
    {haas, kSign, "G12I"},
    {haas, kSign, "G13I"},
    {grbl, kDecides, "^$"},
    {mach, kDecides, "G68A"},
    {mach, kDecides, "G68B"},
    {mach, kDecides, "M98P%Q"},
    {mach, kSign, "M98P%L%Q"},
    {mach, kSign, "G59P"},
    {mach, kSign, "M47"},
    {mach, kSign, "G28.1Z"},
    {mach, kSign, "G28.1X"},
};

/// Upper case, without blanks, comments and the N word.
void strip(std::string_view line, std::string& out) {
    out.clear();
    bool comment = false;
    for (const char c : line) {
        if (c == ';' && !comment)
            break;
        if (c == '(' || comment) {
            comment = c != ')';
            continue;
        }
        if (!isBlank(c))
            out.push_back(upperCase(c));
    }
    std::size_t begin = !out.empty() && out.front() == '/' ? 1 : 0;
    if (begin < out.size() && out[begin] == 'N') {
        ++begin;
        while (begin < out.size() && isDigit(out[begin]))
            ++begin;
    }
    out.erase(0, begin);
}

/// Whether a pattern matches at `at`: "#" is a digit, "%" any number of digits.
bool matchesAt(std::string_view pattern, std::string_view line, std::size_t at) {
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        // A "#" at the beginning of a pattern is that of a parameter.
        const bool digit = pattern[i] == '#' && i > 0;
        if (pattern[i] == '%') {
            while (at < line.size() && isDigit(line[at]))
                ++at;
            continue;
        }
        if (at >= line.size() || (digit ? !isDigit(line[at]) : line[at] != pattern[i]))
            return false;
        ++at;
    }
    // "G100" does not match in "G1000", nor "G150" in "G1500".
    return !isDigit(pattern.back()) || at >= line.size() || !(isDigit(line[at]) || line[at] == '.');
}

/// The comment as it is shown.
std::string shownComment(std::string_view line) {
    constexpr std::size_t kLongest = 48;
    const std::string_view from = line.substr(line.find_first_of("(;"));
    return std::string(from.substr(0, std::min({from.find(')'), from.size() - 1, kLongest - 1}) + 1));
}

std::optional<std::size_t> placeOf(std::string_view pattern, std::string_view line) {
    if (pattern.front() == '^')
        return matchesAt(pattern.substr(1), line, 0) ? std::optional<std::size_t>(0) : std::nullopt;
    for (std::size_t at = line.find(pattern.front()); at != std::string_view::npos;
         at = line.find(pattern.front(), at + 1)) {
        if (matchesAt(pattern, line, at))
            return at;
    }
    return {};
}

} // namespace

DialectGuess guessDialect(const NcText& text) {
    std::vector<DialectSign> signs;
    std::array<bool, std::size(kSignRows)> seen{};
    std::string line;
    const std::size_t most = std::min(text.lineCount(), kMostLines);
    std::array<bool, static_cast<std::size_t>(DialectId::count)> isNamed{};
    for (std::size_t i = 0; i < most; ++i) {
        if (const auto named = i < kMostOfHeading ? namedControl(text.line(i)) : std::nullopt;
            named && !isNamed[static_cast<std::size_t>(named->dialect)]) {
            isNamed[static_cast<std::size_t>(named->dialect)] = true;
            signs.push_back({named->dialect, named->named ? kNamed : kHint, static_cast<int>(i + 1),
                             shownComment(text.line(i))});
        }
        strip(text.line(i), line);
        // Most lines are plain coordinates.
        if (line.find_first_of("GMOIW#:<*$") == std::string::npos)
            continue;
        for (std::size_t row = 0; row < std::size(kSignRows); ++row) {
            const auto at = seen[row] ? std::nullopt : placeOf(kSignRows[row].pattern, line);
            if (!at)
                continue;
            seen[row] = true;
            signs.push_back({kSignRows[row].dialect, kSignRows[row].weight, static_cast<int>(i + 1),
                             line.substr(*at, kLongestShown)});
        }
    }
    std::array<int, static_cast<std::size_t>(DialectId::count)> weights{};
    for (const DialectSign& sign : signs)
        weights[static_cast<std::size_t>(sign.dialect)] += sign.weight;
    // Haas also accepts what Fanuc accepts; without a sign of its own, Haas is not meant.
    const auto of = [&](DialectId id) -> int& { return weights[static_cast<std::size_t>(id)]; };
    if (of(haas) > 0)
        of(haas) += of(fanuc);
    // The same applies to Mach and the codes that LinuxCNC shares with it.
    if (of(mach) > 0 && of(linuxcnc) < kDecides)
        of(mach) += of(linuxcnc);
    DialectGuess guess;
    for (const Dialect& row : dialects()) {
        if (of(row.id) > of(guess.dialect))
            guess.dialect = row.id;
    }
    const DialectId family = guess.dialect == haas ? fanuc : guess.dialect == mach ? linuxcnc : guess.dialect;
    std::ranges::copy_if(signs, std::back_inserter(guess.reasons), [&](const DialectSign& sign) {
        return sign.dialect == guess.dialect || sign.dialect == family;
    });
    return guess;
}

} // namespace proveout
