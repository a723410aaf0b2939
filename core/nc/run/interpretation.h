// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>

#include "core/nc/codes/dialect_guess.h"
#include "core/nc/flow/call_stack.h"
#include "core/nc/run/beginnings.h"
#include "core/nc/run/interpreter.h"
#include "core/nc/run/line_runner.h"
#include "core/nc/run/program_notices.h"
#include "core/nc/run/repeat_guard.h"
#include "core/nc/run/resume_point.h"

namespace proveout {

/// One run through an NC text, line by line: owns what the run makes and remembers, and decides when it ends.
/// Keeps references to its arguments.
class Interpretation {
public:
    Interpretation(const NcText& text, const InterpretOptions& options, DialectGuess guess,
                   const WorkContext& context);
    Interpretation(const Interpretation&) = delete;
    Interpretation& operator=(const Interpretation&) = delete;

    /// Starts at a point of an earlier run instead of the beginning; `earlier` is the result of that run, or
    /// a longer program. The lines before the point must be the same.
    void resume(const ResumePoint& point, const Program& earlier);

    /// Receives a point; returns the line from which on it wants the next one.
    using KeepPoint = std::function<std::size_t(ResumePoint)>;
    void keepPoints(std::size_t firstLine, KeepPoint keep);
    /// Publishes what has been read while it runs.
    void publish(Beginnings& beginnings) { m_beginnings = &beginnings; }

    /// Once.
    [[nodiscard]] std::shared_ptr<const Program> run();

private:
    void begin();
    void end();
    void offerPoint();
    [[nodiscard]] bool lookUp();
    [[nodiscard]] bool runLine();
    /// Whether the program has ended, or its text.
    [[nodiscard]] bool isFinished() const {
        return m_run.memory.machine.ended || m_run.read.percentClosed || m_cutShort;
    }

    const NcText& m_text;
    const InterpretOptions& m_options;
    const WorkContext& m_context;
    const Dialect m_dialect; ///< with the settings of the options
    std::shared_ptr<Program> m_program;
    Reporter m_reporter;
    RunState m_run;
    CallStack m_calls;
    LineRunner m_lines;
    RepeatGuard m_repeats;
    ProgramNotices m_notices;
    KeepPoint m_keepPoint;
    std::size_t m_nextPoint = SIZE_MAX; ///< line
    Beginnings* m_beginnings = nullptr;
    bool m_begun = false;
    bool m_cutShort = false; ///< stopped, or at a limit: the rest of the program is unknown
};

} // namespace proveout
