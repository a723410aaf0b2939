// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/flow/flow_index.h"

#include <algorithm>
#include <optional>

namespace proveout {

namespace {

/// The rows of one open construct, as indices.
struct Open {
    std::vector<std::size_t> parts; ///< if, elseif …; while; repeat; do
    std::vector<std::size_t> jumps; ///< break and continue with this label
};

class Matcher {
public:
    explicit Matcher(std::vector<FlowLine>& rows) : m_rows(rows) {}

    void add(const FlowWord& word) {
        const std::size_t row = m_rows.size() - 1;
        switch (word.kind) {
        case FlowKind::sub:
            m_rows[row].nested = m_sub.has_value();
            m_sub = row;
            m_subLabel = word.label;
            beginScope();
            return;
        case FlowKind::endSub:
            closeSub(word.label, row);
            return;
        case FlowKind::ifs:
        case FlowKind::doLoop:
        case FlowKind::repeat:
            open(word.label, row);
            return;
        case FlowKind::whileLoop:
            addWhile(word.label, row);
            return;
        case FlowKind::elseIf:
        case FlowKind::elses:
            if (Open* found = find(word.label, FlowKind::ifs))
                chain(*found, row);
            return;
        case FlowKind::endIf:
            close(word.label, FlowKind::ifs, row);
            return;
        case FlowKind::endWhile:
            close(word.label, FlowKind::whileLoop, row);
            return;
        case FlowKind::endRepeat:
            close(word.label, FlowKind::repeat, row);
            return;
        case FlowKind::breaks:
        case FlowKind::continues:
            addJump(word.label, row);
            return;
        case FlowKind::programNumber:
        case FlowKind::call:
        case FlowKind::returns:
            return;
        }
    }

private:
    /// Creates new containers rather than clearing them: clearing takes time proportional to the labels of
    /// the largest earlier scope.
    void beginScope() {
        m_open = decltype(m_open)();
        m_first = decltype(m_first)();
    }

    void open(const std::string& label, std::size_t row) {
        m_open[label] = {{row}, {}};
        const auto [first, added] = m_first.emplace(label, m_rows[row].line);
        if (!added)
            m_rows[row].twin = first->second;
    }

    Open* find(const std::string& label, FlowKind kind) {
        const auto found = m_open.find(label);
        const bool fits = found != m_open.end() && m_rows[found->second.parts.front()].kind == kind;
        return fits ? &found->second : nullptr;
    }

    [[nodiscard]] bool isLoop(const Open& construct) const {
        const FlowKind kind = m_rows[construct.parts.front()].kind;
        return kind == FlowKind::whileLoop || kind == FlowKind::doLoop;
    }

    /// In LinuxCNC, break and continue do not leave a repeat or a branch.
    void addJump(const std::string& label, std::size_t row) {
        const auto found = m_open.find(label);
        if (found == m_open.end())
            return;
        if (isLoop(found->second))
            found->second.jumps.push_back(row);
        FlowLine& first = m_rows[found->second.parts.front()];
        if (first.kind == FlowKind::repeat && first.jump == FlowLine::kNone)
            first.jump = m_rows[row].line;
    }

    void chain(Open& construct, std::size_t row) {
        m_rows[construct.parts.back()].next = m_rows[row].line;
        construct.parts.push_back(row);
    }

    void addWhile(const std::string& label, std::size_t row) {
        if (find(label, FlowKind::doLoop) == nullptr) {
            open(label, row);
            return;
        }
        m_rows[row].closesDo = true;
        close(label, FlowKind::doLoop, row);
    }

    void close(const std::string& label, FlowKind kind, std::size_t row) {
        Open* found = find(label, kind);
        if (found == nullptr)
            return;
        chain(*found, row);
        const std::size_t begin = m_rows[found->parts.front()].line;
        const std::size_t end = m_rows[row].line;
        for (const auto& rows : {found->parts, found->jumps}) {
            for (const std::size_t part : rows) {
                m_rows[part].begin = begin;
                m_rows[part].end = end;
            }
        }
        m_open.erase(label);
    }

    void closeSub(const std::string& label, std::size_t row) {
        beginScope();
        if (m_sub && (label.empty() || label == m_subLabel)) {
            m_rows[*m_sub].next = m_rows[*m_sub].end = m_rows[row].line;
            m_rows[row].begin = m_rows[*m_sub].line;
        }
        m_sub.reset();
    }

    std::vector<FlowLine>& m_rows;
    std::unordered_map<std::string, Open> m_open;
    std::unordered_map<std::string, std::size_t> m_first; ///< lines of this scope's labels
    std::optional<std::size_t> m_sub;
    std::string m_subLabel;
};

std::size_t lineOf(const std::unordered_map<std::string, std::size_t>& lines, std::string_view label) {
    const auto found = lines.find(std::string(label));
    return found == lines.end() ? FlowLine::kNone : found->second;
}

} // namespace

FlowIndex::FlowIndex(const NcText& text) {
    Matcher matcher(m_rows);
    for (std::size_t line = 0; line < text.lineCount(); ++line) {
        if (!hasFlowWord(text.line(line)))
            continue;
        const auto word = readFlowWord(text.line(line));
        if (!word)
            continue;
        m_rows.push_back({word->kind, line});
        m_repeats = m_repeats || word->kind == FlowKind::repeat;
        if (word->kind == FlowKind::sub)
            m_subs.emplace(word->label, line);
        if (word->kind == FlowKind::programNumber)
            m_programs.emplace(word->label, line);
        matcher.add(*word);
    }
}

const FlowLine* FlowIndex::at(std::size_t line) const {
    const auto row = std::ranges::lower_bound(m_rows, line, {}, &FlowLine::line);
    return row != m_rows.end() && row->line == line ? &*row : nullptr;
}

std::size_t FlowIndex::sub(std::string_view label) const {
    return lineOf(m_subs, label);
}

std::size_t FlowIndex::program(std::string_view label) const {
    return lineOf(m_programs, label);
}

} // namespace proveout
