// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/flow/outline.h"

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "core/base/utf8.h"
#include "core/nc/codes/dialects.h"
#include "core/nc/flow/jump_target.h"
#include "core/nc/flow/macro_index.h"
#include "core/nc/text/characters.h"
#include "core/nc/text/flow_word.h"
#include "core/nc/text/word_scan.h"

namespace proveout {

namespace {

constexpr std::size_t kLongestName = 80; ///< bytes that are shown
constexpr double kMostTool = 1e9;

/// A line that matters for the outline.
struct OutlineLine {
    std::size_t line = 0;
    std::string_view comment;       ///< of a line that has nothing else
    std::vector<WrittenWord> words; ///< those that begin a section
    std::size_t lastCode = 0;       ///< the number of lines up to the last block before it; 0: there is none
};

bool hasLetter(std::string_view text) {
    return std::ranges::any_of(text,
                               [](char c) { return isLetter(c) || static_cast<unsigned char>(c) >= 0x80; });
}

bool isToolChange(const WrittenWord& word) {
    return word.letter == 'M' && word.value == 6.0;
}

/// Whether a line may have a word that the outline shows; most lines are motions, which are not read further.
bool mayMatter(std::string_view line) {
    return line.find_first_of("TtMmOo:(;") != std::string_view::npos;
}

/// Reads the lines once and adds what they begin.
class OutlineReader {
public:
    OutlineReader(const NcText& text, DialectId dialectId)
        : m_text(text), m_dialect(dialectId), m_macros(dialect(dialectId).macros) {}

    std::vector<Section> read() {
        findLines();
        if (m_macros == MacroLanguage::macroB)
            findLabels();
        for (const OutlineLine& line : m_lines)
            add(line);
        placeComment(m_lastCode, false);
        closeFrom(0, m_text.lineCount());
        return std::move(m_sections);
    }

private:
    void findLines() {
        for (std::size_t line = 0; line < m_text.lineCount(); ++line) {
            const std::string_view content = m_text.line(line);
            OutlineLine read{line, {}, {}, m_lastCode};
            if (mayMatter(content))
                readLine(content, read);
            else if (std::ranges::any_of(content, isLetter))
                m_lastCode = line + 1;
            const bool flow = m_macros != MacroLanguage::macroB && hasFlowWord(content);
            if (!read.comment.empty() || !read.words.empty() || flow)
                m_lines.push_back(std::move(read));
            if (m_firstCode == 0)
                m_firstCode = m_lastCode;
        }
    }

    void readLine(std::string_view content, OutlineLine& read) {
        read.comment = onlyComment(content);
        if (!read.comment.empty())
            return;
        for (const WrittenWord& word : writtenWords(content)) {
            if (word.letter != 'N' && word.letter != 'O')
                m_lastCode = read.line + 1;
            m_changesTools = m_changesTools || isToolChange(word);
            if (word.letter == 'T' || word.letter == 'O' || isToolChange(word))
                read.words.push_back(word);
        }
        if (auto jump = blockJumpOf(content, m_dialect))
            m_jumps.emplace_back(read.line, std::move(*jump));
    }

    /// Finds the lines to which others jump, and adds those that begin nothing else.
    void findLabels() {
        if (m_jumps.empty())
            return;
        const MacroIndex index(m_text);
        for (const auto& [line, jump] : m_jumps) {
            const bool ofCaller = jump.kind == JumpKind::callerBlock && line >= index.programOf(0).end;
            const std::size_t found = index.block(jump.number, ofCaller ? index.programOf(0).first : line);
            if (found != MacroIndex::kNone)
                m_labels.insert(found);
        }
        const std::size_t known = m_lines.size();
        for (const std::size_t label : m_labels) {
            const auto end = m_lines.begin() + static_cast<std::ptrdiff_t>(known);
            const auto next = std::ranges::lower_bound(m_lines.begin(), end, label, {}, &OutlineLine::line);
            if (next == end || next->line != label)
                m_lines.push_back({label, {}, {}, label});
        }
        std::ranges::sort(m_lines, {}, &OutlineLine::line);
    }

    void add(const OutlineLine& line) {
        if (!line.comment.empty())
            return noteComment(line);
        if (m_macros == MacroLanguage::macroB)
            addProgram(line);
        else if (hasFlowWord(m_text.line(line.line)))
            return addFlow(line);
        const std::optional<Section> tool = toolOf(line);
        placeComment(line.lastCode, tool.has_value());
        if (tool)
            open(*tool);
        if (m_labels.contains(line.line))
            addLabel(line.line);
    }

    void noteComment(const OutlineLine& line) {
        // Of several comment lines the first with a letter names the operation.
        const bool continues = m_comment && m_commentEnd == line.line;
        m_commentEnd = line.line + 1;
        if (m_labels.contains(line.line))
            addLabel(line.line);
        if (!hasLetter(line.comment) || continues || m_firstCode == 0 || line.line < m_firstCode)
            return;
        placeComment(line.lastCode, false);
        m_comment = {SectionKind::operation, 0, shown(line.comment), {}, -1, line.line};
        m_comment->begin = static_cast<std::size_t>(line.comment.data() - m_text.line(line.line).data());
        m_comment->end = m_comment->begin + line.comment.size();
    }

    /// The comment before a block begins an operation; the one right before a tool change describes the tool.
    void placeComment(std::size_t lastCode, bool isOfTool) {
        if (!m_comment)
            return;
        Section operation = *std::exchange(m_comment, std::nullopt);
        if (lastCode > operation.line)
            open(std::move(operation));
        else if (isOfTool)
            m_toolComment = operation.name;
    }

    void addProgram(const OutlineLine& line) {
        const std::string_view content = m_text.line(line.line);
        const auto word = std::ranges::find(line.words, 'O', &WrittenWord::letter);
        if (word == line.words.end() || !word->value)
            return;
        placeComment(line.lastCode, false);
        Section program{SectionKind::program, 0, written(content, *word), {}, -1, line.line};
        program.comment = shown(firstComment(content));
        program.begin = word->begin;
        program.end = word->end;
        open(std::move(program));
    }

    void addFlow(const OutlineLine& line) {
        const std::string_view content = m_text.line(line.line);
        const auto word = readFlowWord(content);
        if (!word)
            return;
        if (word->kind == FlowKind::endSub)
            return closeSub(line);
        const bool program = word->kind == FlowKind::programNumber;
        placeComment(line.lastCode, false);
        if (!program && word->kind != FlowKind::sub)
            return;
        const std::string label = word->label.empty() ? "?" : word->label;
        Section section{program ? SectionKind::program : SectionKind::subprogram,
                        0,
                        program ? fmt::format("O{}", label) : label,
                        shown(firstComment(content)),
                        -1,
                        line.line};
        section.begin = word->begin;
        section.end = word->arguments;
        open(std::move(section));
    }

    std::optional<Section> toolOf(const OutlineLine& line) {
        const auto t = std::ranges::find(line.words, 'T', &WrittenWord::letter);
        const auto change = std::ranges::find_if(line.words, isToolChange);
        if (t != line.words.end())
            m_tool = t->value && *t->value >= 0 && *t->value < kMostTool ? static_cast<int>(*t->value) : -1;
        const auto names = change != line.words.end() || m_changesTools ? change : t;
        if (names == line.words.end())
            return {};
        const std::string_view content = m_text.line(line.line);
        Section tool{SectionKind::tool,
                     0,
                     m_tool < 0 ? "T?" : fmt::format("T{}", m_tool),
                     shown(firstComment(content)),
                     m_tool,
                     line.line};
        const WrittenWord& word = t != line.words.end() ? *t : *names;
        tool.begin = word.begin;
        tool.end = word.end;
        return tool;
    }

    void addLabel(std::size_t line) {
        const std::string_view content = m_text.line(line);
        const std::vector<WrittenWord> words = writtenWords(content);
        const auto word = std::ranges::find(words, 'N', &WrittenWord::letter);
        if (word == words.end())
            return;
        Section label{SectionKind::label, 0, written(content, *word), shown(firstComment(content)), -1, line};
        label.begin = word->begin;
        label.end = word->end;
        open(std::move(label));
    }

    void open(Section section) {
        if (section.kind == SectionKind::tool && section.comment.empty())
            section.comment = std::move(m_toolComment);
        m_toolComment.clear();
        closeFrom(levelFor(section.kind), section.line);
        section.depth = m_open.size();
        section.lastLine = section.line;
        if (m_sections.size() >= kMostSections)
            return;
        m_sections.push_back(std::move(section));
        if (m_sections.back().kind != SectionKind::label)
            m_open.push_back(m_sections.size() - 1);
    }

    /// The number of open sections that a new one is within: a subprogram contains all up to its end, others
    /// those that come later in SectionKind.
    [[nodiscard]] std::size_t levelFor(SectionKind kind) const {
        if (kind == SectionKind::program)
            return 0;
        std::size_t level = m_open.size();
        while (level > 0) {
            const SectionKind outer = m_sections[m_open[level - 1]].kind;
            const bool contains = outer == SectionKind::subprogram || outer < kind ||
                                  (kind == SectionKind::subprogram && outer == SectionKind::tool);
            if (contains)
                break;
            --level;
        }
        return level;
    }

    void closeFrom(std::size_t level, std::size_t nextLine) {
        for (; m_open.size() > level; m_open.pop_back()) {
            Section& section = m_sections[m_open.back()];
            section.lastLine = std::max(section.line, nextLine == 0 ? 0 : nextLine - 1);
        }
    }

    void closeSub(const OutlineLine& line) {
        placeComment(line.lastCode, false);
        for (std::size_t level = m_open.size(); level-- > 0;)
            if (m_sections[m_open[level]].kind == SectionKind::subprogram)
                return closeFrom(level, line.line + 1);
    }

    static std::string shown(std::string_view text) { return std::string(shortened(text, kLongestName)); }
    static std::string written(std::string_view content, const WrittenWord& word) {
        std::string name;
        for (const char c : content.substr(word.begin, word.end - word.begin))
            if (!isBlank(c))
                name.push_back(upperCase(c));
        return name;
    }

    const NcText& m_text;
    DialectId m_dialect;
    MacroLanguage m_macros;
    std::vector<std::pair<std::size_t, JumpTarget>> m_jumps; ///< by line
    std::set<std::size_t> m_labels;                          ///< lines to which something jumps
    std::vector<OutlineLine> m_lines;
    bool m_changesTools = false; ///< the text has M6
    std::size_t m_firstCode = 0; ///< the number of lines up to the first block; 0: there is none
    std::size_t m_lastCode = 0;
    std::vector<Section> m_sections;
    std::vector<std::size_t> m_open;  ///< the sections that contain the present line, outermost first
    std::optional<Section> m_comment; ///< which may begin an operation
    std::size_t m_commentEnd = 0;     ///< the line after the last comment line
    std::string m_toolComment;
    int m_tool = -1; ///< the last T word
};

} // namespace

std::vector<Section> outlineOf(const NcText& text, DialectId dialect) {
    return OutlineReader(text, dialect).read();
}

} // namespace proveout
