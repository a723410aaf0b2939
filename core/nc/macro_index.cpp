// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/macro_index.h"

#include <algorithm>
#include <optional>

#include "core/nc/characters.h"
#include "core/nc/macro_statement.h"
#include "core/nc/number.h"

namespace proveout {

namespace {

/// What the beginning of a line says about the order of blocks.
struct Head {
    std::optional<long long> program;
    std::string_view name; ///< of a program, between < and >
    std::optional<long long> label;
    std::optional<MacroStatement> statement;
    bool orders = false; ///< something behind them is carried out
};

std::optional<long long> wholeNumber(std::string_view line, std::size_t& at) {
    const NumberRead number = readNumber(line, at);
    if (number.status != NumberStatus::good)
        return {};
    at = number.end;
    return static_cast<long long>(number.value);
}

Head headOf(std::string_view line) {
    Head head;
    for (std::size_t at = skipBlanks(line, 0); at < line.size(); at = skipBlanks(line, at)) {
        const char c = upperCase(line[at]);
        if (c == '/') {
            at = skipBlanks(line, at + 1);
            if (at < line.size() && line[at] >= '1' && line[at] <= '9')
                ++at;
        } else if (c == 'O' || c == ':') {
            head.program = wholeNumber(line, ++at);
            if (!head.program)
                return head;
        } else if (c == '<' && head.name.empty() && line.find('>', at) != std::string_view::npos) {
            const std::size_t end = line.find('>', at);
            head.name = line.substr(at + 1, end - at - 1);
            at = end + 1;
        } else if (c == 'N' && !head.label) {
            head.label = wholeNumber(line, ++at);
            if (!head.label)
                return head;
        } else if (c == '(') {
            at = std::min(line.find(')', at), line.size() - 1) + 1;
        } else {
            head.statement = readStatement(line, at);
            head.orders = c != '%' && c != ';';
            return head;
        }
    }
    return head;
}

/// The number of the loop that a statement begins or ends.
std::optional<long long> loopOf(std::string_view line, const MacroStatement& statement) {
    std::size_t at = statement.rest;
    if (statement.kind == StatementKind::whileLoop) {
        at = behindBracket(line, skipBlanks(line, at));
        if (!takeKeyword(line, at, "DO"))
            return {};
    } else if (statement.kind != StatementKind::doLoop && statement.kind != StatementKind::endLoop) {
        return {};
    }
    return wholeNumber(line, at);
}

} // namespace

MacroIndex::MacroIndex(const NcText& text) {
    struct Open {
        long long number;
        std::size_t row;
    };
    std::vector<Open> open;
    m_programs.push_back({});
    bool begun = false; ///< an O-word, or something that is carried out without one, was seen
    for (std::size_t line = 0; line < text.lineCount(); ++line) {
        const std::string_view content = text.line(line);
        const Head head = headOf(content);
        if (head.program || !head.name.empty()) {
            open.clear();
            const Range begins{head.program.value_or(-1), std::string(head.name), line, line};
            if (begun) {
                m_programs.back().end = line;
                m_programs.push_back(begins);
            } else {
                m_programs.back() = begins;
            }
        }
        begun = begun || head.program || !head.name.empty() || head.orders;
        if (head.label)
            m_labels.push_back({*head.label, line});
        const auto loop = head.statement ? loopOf(content, *head.statement) : std::nullopt;
        if (!loop)
            continue;
        m_loops.push_back({line, kNone});
        if (head.statement->kind != StatementKind::endLoop) {
            open.push_back({*loop, m_loops.size() - 1});
            continue;
        }
        // Loops lie within one another: one that ends takes those within it, which never ended, along.
        const auto begin =
            std::find_if(open.rbegin(), open.rend(), [&](const Open& o) { return o.number == *loop; });
        if (begin == open.rend())
            continue;
        m_loops.back().partner = m_loops[begin->row].line;
        m_loops[begin->row].partner = line;
        open.erase(std::prev(begin.base()), open.end());
    }
    m_programs.back().end = text.lineCount();
    std::ranges::sort(m_labels);
}

const MacroIndex::Range* MacroIndex::program(long long number) const {
    const auto found = std::ranges::find(m_programs, number, &Range::number);
    return found == m_programs.end() ? nullptr : &*found;
}

const MacroIndex::Range* MacroIndex::program(std::string_view name) const {
    const auto found = std::ranges::find(m_programs, name, &Range::name);
    return found == m_programs.end() ? nullptr : &*found;
}

const MacroIndex::Range& MacroIndex::programOf(std::size_t line) const {
    const auto behind = std::ranges::upper_bound(m_programs, line, {}, &Range::first);
    return behind == m_programs.begin() ? m_programs.front() : *std::prev(behind);
}

std::size_t MacroIndex::block(long long number, std::size_t line) const {
    const Range& program = programOf(line);
    const auto search = [&](std::size_t first, std::size_t end) {
        const auto row = std::ranges::lower_bound(m_labels, Label{number, first});
        const bool found = row != m_labels.end() && row->number == number && row->line < end;
        return found ? row->line : kNone;
    };
    const std::size_t ahead = search(line + 1, program.end);
    return ahead != kNone ? ahead : search(program.first, std::min(line + 1, program.end));
}

bool MacroIndex::repeated(long long number, std::size_t line) const {
    const Range& program = programOf(line);
    const auto first = std::ranges::lower_bound(m_labels, Label{number, program.first});
    const auto end = std::ranges::lower_bound(m_labels, Label{number, program.end});
    return end - first > 1;
}

std::size_t MacroIndex::partner(std::size_t line) const {
    const auto row = std::ranges::lower_bound(m_loops, line, {}, &Loop::line);
    return row != m_loops.end() && row->line == line ? row->partner : kNone;
}

} // namespace proveout
