// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/diagnostic.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <iterator>

#include "core/base/list_argument.h"
#include "core/base/utf8.h"

namespace proveout {

namespace {

struct CodeRange {
    char32_t first;
    char32_t last;
};

/// Characters that a terminal obeys instead of showing them: control codes, marks that change the direction
/// of the text, ends of lines and paragraphs.
constexpr std::array kObeyed{CodeRange{0, 0x1f},        CodeRange{0x7f, 0x9f},     CodeRange{0x61c, 0x61c},
                             CodeRange{0x200e, 0x200f}, CodeRange{0x2028, 0x202e}, CodeRange{0x2066, 0x2069},
                             CodeRange{0xfeff, 0xfeff}};

bool isShown(const Utf8Character& character) {
    return character.valid && std::ranges::none_of(kObeyed, [&](const CodeRange& range) {
               return character.code >= range.first && character.code <= range.last;
           });
}

std::string escaped(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const Utf8Character character = firstCharacter(text);
        const std::string_view bytes = text.substr(0, character.length);
        if (isShown(character))
            out += bytes;
        else
            for (const char byte : bytes)
                fmt::format_to(std::back_inserter(out), "\\x{:02x}", static_cast<unsigned char>(byte));
        text.remove_prefix(character.length);
    }
    return out;
}

/// The number of a `{1}` … `{9}` at the beginning of `text`, else 0.
std::size_t numberedArgument(std::string_view text) {
    const bool found =
        text.size() >= 3 && text[0] == '{' && text[1] >= '1' && text[1] <= '9' && text[2] == '}';
    return found ? static_cast<std::size_t>(text[1] - '0') : 0;
}

std::string shownArgument(std::string_view argument) {
    return changedList(argument, ", ", [](std::string_view text) { return text; });
}

} // namespace

std::string fillIn(std::string_view text, const std::vector<std::string>& arguments) {
    std::string out;
    std::size_t next = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::size_t numbered = numberedArgument(text.substr(i));
        if (text.substr(i, 2) == "{}" && next < arguments.size()) {
            out += shownArgument(arguments[next++]);
            ++i;
        } else if (numbered > 0 && numbered <= arguments.size()) {
            out += shownArgument(arguments[numbered - 1]);
            i += 2;
        } else {
            out.push_back(text[i]);
        }
    }
    return out;
}

std::string message(const Diagnostic& diagnostic) {
    return fillIn(diagnostic.text, {diagnostic.arguments.begin(), diagnostic.arguments.end()});
}

std::string hintText(const Diagnostic& diagnostic) {
    return fillIn(diagnostic.hint, {diagnostic.arguments.begin(), diagnostic.arguments.end()});
}

const char* name(Severity severity) {
    switch (severity) {
    case Severity::note:
        return "note";
    case Severity::warning:
        return "warning";
    case Severity::error:
        return "error";
    case Severity::fault:
        return "fault";
    }
    return "error";
}

std::string oneLine(const Diagnostic& diagnostic) {
    std::string place = escaped(diagnostic.file.empty() ? std::string_view("proveout") : diagnostic.file);
    if (diagnostic.where.line > 0)
        place += fmt::format(":{}:{}", diagnostic.where.line, diagnostic.where.column);
    return fmt::format("{}: {}: {} [{}]", place, name(diagnostic.severity), escaped(message(diagnostic)),
                       diagnostic.id);
}

} // namespace proveout
