// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/flow/macro_index.h"

#include <algorithm>
#include <optional>

#include "core/nc/text/characters.h"
#include "core/nc/text/macro_statement.h"
#include "core/nc/text/number.h"

namespace proveout {

namespace {

/// The parts of the beginning of a line that matter for the order of blocks.
struct Head {
    std::optional<long long> program;
    std::string_view name; ///< of a program, between < and >
    std::optional<long long> label;
    std::optional<MacroStatement> statement;
    bool orders = false; ///< whether there is something to execute after them
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
        if (!readKeyword(line, at, "DO"))
            return {};
    } else if (statement.kind != StatementKind::doLoop && statement.kind != StatementKind::endLoop) {
        return {};
    }
    return wholeNumber(line, at);
}

/// The open loops, by the numbers of their DO. Loops are nested: an END also closes the loops within its loop
/// that never ended.
class OpenLoops {
public:
    void clear() {
        while (!m_open.empty())
            close();
    }

    void begin(long long number, std::size_t row) {
        m_places[number].push_back(m_open.size());
        m_open.push_back({number, row});
    }

    /// The row of the last loop of that number, which is closed by this; nothing if there is none.
    std::optional<std::size_t> end(long long number) {
        const auto found = m_places.find(number);
        if (found == m_places.end() || found->second.empty())
            return {};
        const std::size_t place = found->second.back();
        const std::size_t row = m_open[place].row;
        while (m_open.size() > place)
            close();
        return row;
    }

private:
    void close() {
        m_places[m_open.back().number].pop_back();
        m_open.pop_back();
    }

    struct Open {
        long long number;
        std::size_t row;
    };
    std::vector<Open> m_open;
    std::unordered_map<long long, std::vector<std::size_t>> m_places; ///< by number: indices into m_open
};

} // namespace

MacroIndex::MacroIndex(const NcText& text) {
    OpenLoops open;
    m_programs.push_back({});
    bool begun = false; ///< whether an O-word, or something to execute without one, was seen
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
            open.begin(*loop, m_loops.size() - 1);
            continue;
        }
        if (const auto begin = open.end(*loop)) {
            m_loops.back().partner = m_loops[*begin].line;
            m_loops[*begin].partner = line;
        }
    }
    m_programs.back().end = text.lineCount();
    for (std::size_t row = 0; row < m_programs.size(); ++row) {
        m_byNumber.emplace(m_programs[row].number, row);
        m_byName.emplace(m_programs[row].name, row);
    }
    std::ranges::sort(m_labels);
}

const MacroIndex::Range* MacroIndex::program(long long number) const {
    const auto found = m_byNumber.find(number);
    return found == m_byNumber.end() ? nullptr : &m_programs[found->second];
}

const MacroIndex::Range* MacroIndex::program(std::string_view name) const {
    const auto found = m_byName.find(std::string(name));
    return found == m_byName.end() ? nullptr : &m_programs[found->second];
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
