// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/text/macro_statement.h"

#include "core/nc/text/characters.h"

namespace proveout {

namespace {

struct Keyword {
    std::string_view word;
    StatementKind kind;
};

constexpr Keyword kKeywords[] = {
    {"GOTO", StatementKind::gotoBlock}, {"IF", StatementKind::ifs},       {"WHILE", StatementKind::whileLoop},
    {"DO", StatementKind::doLoop},      {"END", StatementKind::endLoop},  {"DPRNT", StatementKind::output},
    {"BPRNT", StatementKind::output},   {"POPEN", StatementKind::output}, {"PCLOS", StatementKind::output},
};

} // namespace

bool readKeyword(std::string_view line, std::size_t& at, std::string_view keyword) {
    std::size_t next = at;
    for (const char c : keyword) {
        next = skipBlanks(line, next);
        if (next >= line.size() || upperCase(line[next]) != c)
            return false;
        ++next;
    }
    at = next;
    return true;
}

std::optional<MacroStatement> readStatement(std::string_view line, std::size_t at) {
    for (const Keyword& row : kKeywords) {
        std::size_t rest = at;
        if (readKeyword(line, rest, row.word))
            return MacroStatement{row.kind, skipBlanks(line, at), rest};
    }
    return {};
}

} // namespace proveout
