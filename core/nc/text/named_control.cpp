// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/text/named_control.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include "core/nc/text/characters.h"

namespace proveout {

namespace {

using enum DialectId;

/// A name of a control, as it occurs in a comment in upper case.
struct NameRow {
    DialectId dialect;
    std::string_view name;
};

constexpr NameRow kNames[] = {
    {linuxcnc, "LINUXCNC"}, {linuxcnc, "EMC2"},  {fanuc, "FANUC"},    {haas, "HAAS"},      {grbl, "GRBL"},
    {mach, "MACH2"},        {mach, "MACH3"},     {mach, "MACH4"},     {mach, "MACH 3"},    {mach, "MACH 4"},
    {grbl, "GRBLHAL"},      {mach, "MACH2MILL"}, {mach, "MACH3MILL"}, {mach, "MACH4MILL"},
};

/// Next to one of these, a name is that of the post processor or of the control, not one in prose.
constexpr std::string_view kContexts[] = {" POST ",      " POSTPROCESSOR ", " POSTPROCESS ", " PREPROCESSOR ",
                                          " GCODE FOR ", " CODE FOR ",      " OUTPUT FOR "};
/// The same if the comment begins with one of these.
constexpr std::string_view kKeys[] = {" MACHINE ", " CONTROL ", " CONTROLLER ", " VENDOR ", " MODEL "};

/// Texts that the posts of Autodesk's CAM write for Haas, and few others.
constexpr std::string_view kHaasTexts[] = {" USING G0 WHICH TRAVELS ALONG DOGLEG PATH ",
                                           " USING HIGH FEED G1 F"};

/// The comment of a line, its words in upper case with one blank around each; empty if there is none.
std::string commentOf(std::string_view line) {
    std::string out;
    const std::size_t begin = line.find_first_of("(;");
    if (begin == std::string_view::npos)
        return out;
    out.push_back(' ');
    for (const char c : line.substr(begin + 1)) {
        const char u = upperCase(c);
        const bool word = isDigit(u) || (u >= 'A' && u <= 'Z');
        if (word)
            out.push_back(u);
        else if (out.back() != ' ')
            out.push_back(' ');
        if (c == ')')
            break;
    }
    if (out.back() != ' ')
        out.push_back(' ');
    return out;
}

/// Whether a comment names the control it was written for: beside "post", after "machine", or alone with its
/// model: "(FANUC 0M)", but not "(Fanuc M98 needs a P word)".
bool isNamed(std::string_view comment, std::string_view name) {
    constexpr std::ptrdiff_t kMostBlanks = 4; // around three words
    const std::string word = ' ' + std::string(name) + ' ';
    if (comment.find(word) == std::string_view::npos)
        return false;
    const auto holds = [&](std::string_view text) { return comment.find(text) != std::string_view::npos; };
    const auto begins = [&](std::string_view text) { return comment.starts_with(text); };
    return std::ranges::any_of(kContexts, holds) || std::ranges::any_of(kKeys, begins) ||
           (begins(word) && std::ranges::count(comment, ' ') <= kMostBlanks);
}

} // namespace

std::optional<NamedControl> namedControl(std::string_view line) {
    const std::string comment = commentOf(line);
    for (const NameRow& row : kNames) {
        if (isNamed(comment, row.name))
            return NamedControl{row.dialect, true};
    }
    if (std::ranges::any_of(kHaasTexts,
                            [&](auto text) { return comment.find(text) != std::string_view::npos; }))
        return NamedControl{haas, false};
    return {};
}

} // namespace proveout
