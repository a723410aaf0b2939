// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>

#include "core/nc/codes/dialect_guess.h"
#include "core/nc/flow/call_stack.h"
#include "core/nc/run/interpreter.h"
#include "core/nc/run/line_runner.h"
#include "core/nc/run/program_notices.h"
#include "core/nc/run/repeat_guard.h"
#include "core/nc/run/resume_point.h"

namespace proveout {

/// One run through an NC text, line by line: owns what the run makes and remembers, and decides how long it
/// goes on. Keeps references to its arguments.
class Interpretation {
public:
    Interpretation(const NcText& text, const InterpretOptions& options, DialectGuess guess,
                   const WorkContext& context);
    Interpretation(const Interpretation&) = delete;
    Interpretation& operator=(const Interpretation&) = delete;

    /// Instead of at the beginning: at a point of an earlier run, of which `earlier` is the result, or a
    /// longer program. The lines before it must be the same.
    void resume(const ResumePoint& point, const Program& earlier);

    /// Is handed a point and the program so far; returns the line from which on it wants the next one.
    using KeepPoint = std::function<std::size_t(ResumePoint, const Program&)>;
    void keepPoints(std::size_t firstLine, KeepPoint keep);

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
    const Dialect m_dialect; ///< as the options set it
    std::shared_ptr<Program> m_program;
    Reporter m_reporter;
    RunState m_run;
    CallStack m_calls;
    LineRunner m_lines;
    RepeatGuard m_repeats;
    ProgramNotices m_notices;
    KeepPoint m_keepPoint;
    std::size_t m_nextPoint = SIZE_MAX; ///< line
    bool m_begun = false;
    bool m_cutShort = false; ///< stopped, or at a limit: what the rest of the program says is not known
};

} // namespace proveout
