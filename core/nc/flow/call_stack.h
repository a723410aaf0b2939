// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/nc/flow/flow_index.h"
#include "core/nc/flow/macro_index.h"
#include "core/nc/program/reporter.h"
#include "core/nc/text/nc_text.h"
#include "core/nc/text/parameters.h"

namespace proveout {

/// Determines which line of which text comes next and which line called it, and limits calls and lines. Keeps
/// references to its arguments.
class CallStack {
public:
    struct Limits {
        const std::vector<std::filesystem::path>& folders; ///< for subprograms in separate files
        std::size_t deepest;                               ///< of nested calls
    };

    /// The number of lines of a text up to the last one that has run: in the program itself, and in calls,
    /// which are often after it.
    struct Reached {
        std::size_t inProgram = 0;
        std::size_t inCalls = 0;
    };

    struct Source {
        NcText text;
        std::string file;
        std::optional<FlowIndex> flow;   ///< built on first use
        std::optional<MacroIndex> macro; ///< built on first use
        std::size_t number = 0;          ///< of the texts, in the order of their first use
        Reached reached;                 ///< in this text
    };

    using Counts = std::unordered_map<std::size_t, std::uint64_t>;
    struct Level {
        Source* source = nullptr; ///< of the caller
        std::size_t line = 0;     ///< where the caller continues
        std::size_t entry = 0;    ///< first line of the subprogram
        std::string label;
        std::optional<int> repeats;     ///< further runs, of M98 and similar codes; nothing for O-words
        bool ownLocals = true;          ///< the subprogram has local parameters of its own
        bool sharesNumbers = false;     ///< if it has its own, numbered ones are still those of the caller,
                                        ///< and only named ones its own
        Parameters::Locals arguments{}; ///< the initial values of its own locals
        Counts counts;                  ///< remaining rounds of "repeat", of the caller
    };

    CallStack(const NcText& main, std::string file, const Limits& limits, Parameters& parameters,
              Reporter& reporter);

    [[nodiscard]] bool atEnd() const { return m_line >= m_source->text.lineCount(); }
    [[nodiscard]] std::size_t line() const { return m_line; } ///< the next line, 0-based, of text()
    [[nodiscard]] const NcText& text() const { return m_source->text; }
    [[nodiscard]] std::size_t at() const { return m_at; } ///< the line that step() has passed
    /// Whether this line, or one after it, has run before.
    [[nodiscard]] bool isAgain() const { return m_again; }
    [[nodiscard]] std::string_view currentText() const { return m_source->text.line(m_at); }
    /// Whether text() is that of the program, not of a subprogram in a separate file.
    [[nodiscard]] bool inMainText() const { return m_source == m_sources.front().get(); }
    /// The line of the main text, 0-based: this one, or the one with the call.
    [[nodiscard]] std::size_t mainLine() const;
    [[nodiscard]] std::uint32_t mainLineNumber() const { ///< the same, 1-based
        return static_cast<std::uint32_t>(mainLine() + 1);
    }
    [[nodiscard]] bool inMainProgram() const { return m_levels.empty(); }
    [[nodiscard]] Level& level() { return m_levels.back(); }                 ///< only within a call
    [[nodiscard]] std::span<const Level> levels() const { return m_levels; } ///< the outermost first
    /// The file of the line with the call; empty if that is the program itself.
    [[nodiscard]] std::string fileOf(const Level& level) const {
        return level.source == m_sources.front().get() ? std::string() : level.source->file;
    }
    [[nodiscard]] Source& source() { return *m_source; }
    [[nodiscard]] Counts& counts() { return m_counts; }
    [[nodiscard]] const FlowIndex& flowIndex();
    [[nodiscard]] const MacroIndex& macroIndex() { return macroIndex(*m_source); }
    [[nodiscard]] const MacroIndex& macroIndex(Source& source);

    /// The state of a main program between two lines. A value.
    struct Place {
        std::size_t line = 0; ///< the next line
        Reached reached;
        std::uint64_t endedRuns = 0;
        std::uint64_t roundsCounted = 0;
        Counts counts;
        bool indexAsked = false; ///< whether O-words, programs or block numbers have been looked up
    };
    /// Nothing within a call, or once a subprogram was searched for in a file, which may change.
    [[nodiscard]] std::optional<Place> place() const;
    void continueAt(const Place& place);

    /// Advances to the next line.
    void step();
    /// Makes another line the current one.
    void moveTo(std::size_t line) {
        m_at = line;
        m_reporter.beginLine(static_cast<std::uint32_t>(line + 1));
    }
    void jump(std::size_t line) { m_line = line; }
    /// Ends the text here, whatever follows.
    void endText() { m_line = m_source->text.lineCount(); }

    /// Whether a further call is allowed.
    [[nodiscard]] bool mayCall() const { return m_levels.size() < m_limits.deepest; }
    [[nodiscard]] std::size_t deepest() const { return m_limits.deepest; }
    /// Begins a subprogram at line `level.entry` of `source`.
    void enter(Source& source, Level level, const Parameters::Locals& arguments);
    /// Begins another run of the subprogram: with the arguments of its call, or with the locals unchanged.
    void again(bool withArguments);
    /// How many runs of subprograms have ended.
    [[nodiscard]] std::uint64_t endedRuns() const { return m_endedRuns; }
    [[nodiscard]] std::size_t depth() const { return m_levels.size(); }
    /// The lowest number of open calls since the last call of this function.
    [[nodiscard]] std::size_t resetLowestDepth() { return std::exchange(m_lowestDepth, m_levels.size()); }
    /// Counts a round of a counted loop.
    void noteRound() { ++m_roundsCounted; }
    [[nodiscard]] std::uint64_t roundsCounted() const { return m_roundsCounted; }
    /// Returns to the caller.
    void leave();

    enum class FileFault : std::uint8_t { none, unknown, outside, unreadable };
    struct FileFound {
        Source* source = nullptr; ///< null in case of an error
        FileFault fault = FileFault::none;
        std::string reason; ///< for `unreadable`
    };
    /// The first of `names` that exists in one of the folders. Links that lead out of the folder are not
    /// followed.
    [[nodiscard]] FileFound file(const std::vector<std::string>& names);

    [[nodiscard]] std::string linesOfCalls() const;                 ///< "12 (O100) > 3"
    [[nodiscard]] std::string chain(const std::string& last) const; ///< "100 > 200 > last"

private:
    Limits m_limits;
    Parameters& m_parameters;
    Reporter& m_reporter;
    std::vector<std::unique_ptr<Source>> m_sources;
    Source* m_source;
    std::size_t m_line = 0; ///< next
    std::size_t m_at = 0;   ///< the current line
    bool m_again = false;
    std::uint64_t m_endedRuns = 0;
    std::uint64_t m_roundsCounted = 0;
    std::size_t m_lowestDepth = 0;
    bool m_indexAsked = false;
    bool m_filesAsked = false;
    std::vector<Level> m_levels;
    Counts m_counts; ///< remaining rounds of "repeat", by its line
};

} // namespace proveout
