// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/setup/tool_proposals.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/tool_number.h"
#include "core/base/utf8.h"
#include "core/cutter/entered_sizes.h"
#include "core/cutter/tool_comment.h"
#include "core/nc/text/characters.h"

namespace proveout {

namespace {

constexpr std::size_t kMostLines = 1'000'000;
constexpr std::size_t kMostComments = 100'000;
constexpr std::size_t kMostTools = 1'000;
constexpr std::size_t kUnitLines = 10'000;   ///< the unit is programmed within the first of them
constexpr std::size_t kLongestComment = 160; ///< bytes that are shown
constexpr std::size_t kGap = 4;              ///< lines between two comments about the same tool

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

/// The contents of a line that concern tools. Comments are views of the line.
struct ToolWords {
    std::vector<std::string_view> comments;
    std::optional<int> tool; ///< T with a number
    bool computedTool = false;
    bool change = false; ///< M6
    bool motion = false; ///< an axis word
    std::optional<bool> inch;

    void clear() {
        comments.clear();
        tool.reset();
        computedTool = change = motion = false;
        inch.reset();
    }
};

/// Reads the words outside comments by their letters; expressions and names of parameters contain no words.
class LineScanner {
public:
    LineScanner(std::string_view line, ToolWords& words) : m_line(line), m_words(words) { words.clear(); }

    void run() {
        while (m_at < m_line.size())
            step();
    }

private:
    void step() {
        const char c = m_line[m_at];
        if (c == '(')
            return readComment(m_line.find(')', m_at));
        if (c == ';')
            return readComment(std::string_view::npos);
        if (c == '<')
            m_at = std::min(m_line.find('>', m_at), m_line.size() - 1);
        else if (c == '[')
            m_at = behindBracket(m_line, m_at) - 1;
        else if (isLetter(c))
            return readLetters();
        ++m_at;
    }

    static bool isLetter(char c) { return upperCase(c) >= 'A' && upperCase(c) <= 'Z'; }

    void readComment(std::size_t end) {
        m_words.comments.push_back(
            m_line.substr(m_at + 1, end == std::string_view::npos ? end : end - m_at - 1));
        m_at = end == std::string_view::npos ? m_line.size() : end + 1;
    }

    /// One letter is the address of a word; several are an operator or a statement.
    void readLetters() {
        const std::size_t first = m_at;
        while (m_at < m_line.size() && isLetter(m_line[m_at]))
            ++m_at;
        if (m_at == first + 1)
            readWord(upperCase(m_line[first]));
    }

    void readWord(char letter) {
        const std::size_t at = skipBlanks(m_line, m_at);
        const char next = at < m_line.size() ? m_line[at] : '\0';
        const bool computed = next == '#' || next == '[' || next == '{';
        if (letter == 'X' || letter == 'Y' || letter == 'Z')
            m_words.motion = m_words.motion || computed || isDigit(next) || next == '.' || next == '-';
        else if (letter == 'T' && computed)
            m_words.computedTool = true;
        else if (isDigit(next))
            readCode(letter, at);
    }

    void readCode(char letter, std::size_t at) {
        std::size_t end = at;
        while (end < m_line.size() && isDigit(m_line[end]))
            ++end;
        const std::string_view digits = m_line.substr(at, end - at);
        m_at = end;
        if (end < m_line.size() && m_line[end] == '.')
            return; // G20.1 is a different code
        if (letter == 'T' && std::ranges::all_of(digits, [](char c) { return c == '0'; }))
            m_words.tool = 0;
        else if (letter == 'T')
            m_words.tool = parseToolNumber(digits);
        else if (letter == 'M' && (digits == "6" || digits == "06"))
            m_words.change = true;
        else if (letter == 'G' && (digits == "20" || digits == "70"))
            m_words.inch = true;
        else if (letter == 'G' && (digits == "21" || digits == "71"))
            m_words.inch = false;
    }

    std::string_view m_line;
    ToolWords& m_words;
    std::size_t m_at = 0;
};

/// What comments state about one tool, and where.
struct Described {
    ToolComment tool;
    std::uint32_t line = 0;
    std::string text;
};

std::string shownText(std::string_view comment) {
    const auto first = comment.find_first_not_of(" \t");
    const auto last = comment.find_last_not_of(" \t\r");
    if (first == std::string_view::npos)
        return {};
    return std::string(shortened(comment.substr(first, last - first + 1), kLongestComment));
}

/// Goes through the lines and determines to which tool each description belongs.
class ProposalSearch {
public:
    explicit ProposalSearch(bool inch) : m_inch(inch) {}

    void addLine(const ToolWords& words, std::uint32_t line) {
        m_inch = words.inch.value_or(m_inch);
        if (words.tool || words.change || words.motion)
            closeDescription();
        // A comment is in the same block as its T, before or after it.
        if (words.tool || words.computedTool)
            select(words);
        if (words.change)
            changeTool();
        for (const std::string_view comment : words.comments)
            addComment(comment, line);
        if (words.tool || words.change || words.motion)
            closeDescription();
        if (words.motion)
            move();
    }

    ToolProposals take() {
        closeDescription();
        keepForNoTool();
        ToolProposals out;
        for (auto& [number, described] : m_byTool)
            add(out.tools, number, described);
        for (Described& described : m_withoutTool)
            add(out.tools, numberFor(out.tools), described);
        out.called = std::move(m_called);
        out.callsComputed = m_callsComputed;
        return out;
    }

private:
    void addComment(std::string_view comment, std::uint32_t line) {
        if (m_comments == kMostComments)
            return;
        ++m_comments;
        ToolComment tool = readToolComment(comment, m_inch);
        if (tool.isEmpty() && !tool.aboutTool)
            return;
        if (m_open.line != 0 && line > m_openLast + kGap)
            closeDescription();
        if (m_open.line == 0 || !extend(m_open.tool, tool)) {
            closeDescription();
            m_open = {tool, line, shownText(comment)};
        } else if (tool.diameter) {
            m_open.line = line; // the line to show is the one with the size
            m_open.text = shownText(comment);
        }
        m_openLast = line;
    }

    /// The description is complete: it is assigned to its tool.
    void closeDescription() {
        Described described = std::exchange(m_open, {});
        if (described.line == 0 || !described.tool.isComplete())
            return;
        if (described.tool.number)
            describeNumbered(std::move(described));
        else if (m_current >= 0 && !m_moved && !m_byTool.contains(m_current))
            describe(m_current, std::move(described));
        else
            m_pending = std::move(described);
    }

    void select(const ToolWords& words) {
        m_callsComputed = m_callsComputed || words.computedTool;
        m_selected = words.tool.value_or(-1);
        if (m_selected < 0)
            return;
        if (m_called.size() < kMostTools)
            m_called.insert(m_selected);
        if (m_pending) {
            Described described = *std::exchange(m_pending, std::nullopt);
            describe(m_selected, std::move(described));
        }
        // A tool selected after the change is preselected: a description here belongs to the tool in the
        // spindle.
        if (m_moved || !m_changed || words.change)
            m_current = m_selected;
        m_moved = false;
        m_changed = false;
    }

    void changeTool() {
        if (m_selected >= 0)
            m_current = m_selected;
        m_changed = true;
        m_moved = false;
    }

    void move() {
        m_moved = true;
        m_changed = false;
        keepForNoTool();
    }

    /// If no tool call follows the description, it belongs to the tool of a program that calls none.
    void keepForNoTool() {
        if (!m_pending)
            return;
        Described described = *std::exchange(m_pending, std::nullopt);
        if (m_withoutTool.size() == kMostTools)
            return;
        // A program may repeat its comments at every motion.
        const auto made = makeCutter(described.tool);
        if (!made || m_cuttersWithoutTool.insert(made->cutter.spec()).second)
            m_withoutTool.push_back(std::move(described));
    }

    void describeNumbered(Described described) {
        const int number = *described.tool.number;
        describe(number, std::move(described));
    }

    /// The first description of a tool counts; one that names the tool overrides one beside its call.
    void describe(int number, Described described) {
        const auto known = m_byTool.find(number);
        if (known == m_byTool.end()) {
            if (m_byTool.size() < kMostTools)
                m_byTool.emplace(number, std::move(described));
        } else if (!known->second.tool.number && described.tool.number) {
            known->second = std::move(described);
        }
    }

    static int numberFor(const ToolTable& tools) {
        int number = 1;
        while (tools.find(number) != nullptr)
            ++number;
        return number;
    }

    static void add(ToolTable& tools, int number, Described& described) {
        auto made = makeCutter(described.tool);
        if (!made)
            return;
        tools.set(
            number, std::move(made->cutter),
            {ToolSource::comment, described.line, std::move(described.text), std::move(made->defaults)});
    }

    bool m_inch;
    std::size_t m_comments = 0;
    Described m_open; ///< comments that may be continued; line 0: none
    std::uint32_t m_openLast = 0;
    std::optional<Described> m_pending; ///< waits for the next tool call
    std::map<int, Described> m_byTool;
    std::vector<Described> m_withoutTool;
    std::set<std::string> m_cuttersWithoutTool; ///< their specs
    std::set<int> m_called;
    bool m_callsComputed = false;
    int m_selected = -1;    ///< number of the last T
    int m_current = -1;     ///< the tool that a comment at this place belongs to
    bool m_changed = false; ///< M6 since the last motion
    bool m_moved = false;   ///< since the last T or M6
};

/// The unit for reading the header, which often comes before G20.
bool beginsInInch(const NcText& text) {
    ToolWords words;
    const std::size_t lines = std::min(text.lineCount(), kUnitLines);
    for (std::size_t index = 0; index < lines; ++index) {
        LineScanner(text.line(index), words).run();
        if (words.inch)
            return *words.inch;
    }
    return false;
}

} // namespace

ToolProposals proposeTools(const NcText& text) {
    ProposalSearch search(beginsInInch(text));
    ToolWords words;
    const std::size_t lines = std::min(text.lineCount(), kMostLines);
    for (std::size_t index = 0; index < lines; ++index) {
        LineScanner(text.line(index), words).run();
        search.addLine(words, static_cast<std::uint32_t>(index + 1));
    }
    return search.take();
}

void addProposals(ToolTable& tools, const ToolProposals& proposals, const ToolProposals& before) {
    const bool empty = tools.tools().empty();
    const auto isOffered = [](const ToolProposals& by, int number) {
        const bool callsNone = by.called.empty() && !by.callsComputed;
        return by.tools.find(number) != nullptr &&
               (callsNone || by.callsComputed || by.called.contains(number));
    };
    const bool callsNone = proposals.called.empty() && !proposals.callsComputed;
    for (const auto& [number, cutter] : proposals.tools.tools()) {
        const ToolOrigin* present = tools.unconfirmedOrigin(number);
        const bool follows = present != nullptr && present->source == ToolSource::comment;
        const bool wanted = tools.find(number) == nullptr && isOffered(proposals, number) &&
                            !isOffered(before, number) && (empty || !callsNone);
        if (!follows && !wanted)
            continue;
        SourcedCutter proposed{cutter, *proposals.tools.unconfirmedOrigin(number)};
        if (follows)
            proposed = withEntered(proposed, {*tools.find(number), *present});
        tools.set(number, std::move(proposed.cutter), std::move(proposed.origin));
    }
}

} // namespace proveout
