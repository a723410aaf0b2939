// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/nc/expression.h"
#include "core/nc/flow_index.h"
#include "core/nc/flow_word.h"
#include "core/nc/nc_text.h"
#include "core/nc/parameters.h"
#include "core/nc/reporter.h"

namespace proveout {

/// Where the calls and jumps of a block lead: set by the handlers of M98, M99 and their like, carried out
/// when the block is done.
struct FlowRequest {
    enum class Kind : std::uint8_t { none, call, returns };
    Kind kind = Kind::none;
    int program = 0;
    int repeats = 1;
    Word word; ///< that asked for it
};

/// Which line of which text comes next: subprograms, branches, loops, and their limits. Source: LinuxCNC's
/// documentation of O-codes. Keeps references to its arguments.
class ControlFlow {
public:
    static constexpr std::size_t kDeepest = 9;        ///< calls within calls, as in LinuxCNC
    static constexpr std::size_t kMostArguments = 30; ///< of a call

    struct Limits {
        std::uint64_t maxSteps;                            ///< lines that may be run through
        const std::vector<std::filesystem::path>& folders; ///< of subprograms in files of their own
    };

    ControlFlow(const NcText& main, std::string file, const Limits& limits, Parameters& parameters,
                const SystemValues& system, Reporter& reporter);

    [[nodiscard]] bool atEnd() const { return m_line >= m_source->text.lineCount(); }
    [[nodiscard]] std::size_t line() const { return m_line; } ///< the next one, 0-based, of text()
    [[nodiscard]] const NcText& text() const { return m_source->text; }
    [[nodiscard]] std::size_t at() const { return m_at; } ///< the line that step() has left
    /// Whether text() is that of the program, not of a subprogram in a file of its own.
    [[nodiscard]] bool inMainText() const { return m_source == m_sources.front().get(); }
    /// The line of the main text, 0-based: this one, or the one that called.
    [[nodiscard]] std::size_t mainLine() const;

    /// To the line behind this one. False, and told, where the limit of steps is reached.
    [[nodiscard]] bool step();
    /// Carries out the O-word of the line that step() has just left. False, and told, where it cannot be.
    [[nodiscard]] bool run(const FlowWord& word);
    /// Carries out what a block asked for. False, and told, where it cannot be. A return from the main
    /// program is left to the caller.
    [[nodiscard]] bool run(const FlowRequest& request);
    [[nodiscard]] bool inMainProgram() const { return m_levels.empty(); }
    [[nodiscard]] std::size_t depth() const { return m_levels.size(); } ///< of calls; 0: main program
    /// How many runs of subprograms have ended; M98 with L makes several.
    [[nodiscard]] std::uint64_t endedRuns() const { return m_endedRuns; }
    /// At the end of a text: back to the caller; false in the main program.
    [[nodiscard]] bool leaveFile();

private:
    struct Source {
        NcText text;
        std::string file;
        std::optional<FlowIndex> index;
    };
    struct Level {
        Source* source = nullptr; ///< of the caller
        std::size_t line = 0;     ///< where the caller goes on
        std::size_t entry = 0;    ///< first line of the subprogram
        std::string label;
        std::optional<int> repeats;                            ///< further runs, of M98; nothing for O-words
        std::unordered_map<std::size_t, std::uint64_t> counts; ///< rounds left of "repeat", of the caller
    };
    using Locals = Parameters::Locals;

    [[nodiscard]] const FlowIndex& index();
    [[nodiscard]] std::string_view currentText() const { return m_source->text.line(m_at); }
    bool fail(const Message& message, const FlowWord& word, std::vector<std::string> arguments = {});
    bool fail(const ReadError& error);

    [[nodiscard]] bool wellFormed(const FlowWord& word);
    [[nodiscard]] std::optional<std::string> labelOf(const FlowWord& word);
    [[nodiscard]] std::optional<double> bracket(const FlowWord& word, std::size_t& at);
    [[nodiscard]] bool nothingBehind(std::size_t at);
    [[nodiscard]] std::optional<bool> condition(const FlowWord& word);
    [[nodiscard]] std::optional<std::size_t> partner(const FlowWord& word, std::size_t FlowLine::*which,
                                                     std::string_view missing);

    bool beginSub(const FlowWord& word);
    bool call(const FlowWord& word);
    bool readArguments(const FlowWord& word, Locals& arguments);
    bool enter(Source& source, std::size_t entry, Level level, const Locals& arguments);
    bool endSub(const FlowWord& word);
    void leave();
    bool branch(const FlowWord& word);
    bool beginWhile(const FlowWord& word);
    bool endLoop(const FlowWord& word);
    bool beginRepeat(const FlowWord& word);
    bool endRepeat(const FlowWord& word);
    Source* fileOf(const std::string& label, const FlowWord& word);
    [[nodiscard]] std::string chain(const std::string& last) const;
    [[nodiscard]] std::string linesOfCalls() const; ///< "12 (O100) > 3"

    Limits m_limits;
    Parameters& m_parameters;
    const SystemValues& m_system;
    Reporter& m_reporter;
    std::vector<std::unique_ptr<Source>> m_sources;
    Source* m_source;
    std::size_t m_line = 0; ///< next
    std::size_t m_at = 0;   ///< the line that is being carried out
    std::uint64_t m_steps = 0;
    std::uint64_t m_endedRuns = 0;
    std::vector<Level> m_levels;
    std::unordered_map<std::size_t, std::uint64_t> m_counts; ///< rounds left of "repeat", by its line
};

} // namespace proveout
