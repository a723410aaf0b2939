// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/diagnostic.h"

#include <fmt/format.h>
#include <iterator>

namespace proveout {

namespace {

std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte == 0x7f)
            fmt::format_to(std::back_inserter(out), "\\x{:02x}", byte);
        else
            out.push_back(c);
    }
    return out;
}

/// The number of a `{1}` … `{9}` at the beginning of `text`, else 0.
std::size_t numberedArgument(std::string_view text) {
    const bool found =
        text.size() >= 3 && text[0] == '{' && text[1] >= '1' && text[1] <= '9' && text[2] == '}';
    return found ? static_cast<std::size_t>(text[1] - '0') : 0;
}

} // namespace

std::string fillIn(std::string_view text, const std::vector<std::string>& arguments) {
    std::string out;
    std::size_t next = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::size_t numbered = numberedArgument(text.substr(i));
        if (text.substr(i, 2) == "{}" && next < arguments.size()) {
            out += arguments[next++];
            ++i;
        } else if (numbered > 0 && numbered <= arguments.size()) {
            out += arguments[numbered - 1];
            i += 2;
        } else {
            out.push_back(text[i]);
        }
    }
    return out;
}

std::string message(const Diagnostic& diagnostic) {
    return fillIn(diagnostic.text, diagnostic.arguments);
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

tl::unexpected<Diagnostics> failure(const char* id, const char* text, std::vector<std::string> arguments,
                                    std::string file) {
    Diagnostic diagnostic;
    diagnostic.id = id;
    diagnostic.text = text;
    diagnostic.arguments = std::move(arguments);
    diagnostic.file = std::move(file);
    return tl::unexpected<Diagnostics>(Diagnostics{std::move(diagnostic)});
}

} // namespace proveout
