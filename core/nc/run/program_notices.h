// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <utility>

#include "core/nc/codes/dialect_guess.h"
#include "core/nc/program/program.h"
#include "core/nc/program/reporter.h"
#include "core/nc/run/interpreter.h"
#include "core/nc/run/run_state.h"
#include "core/nc/text/nc_text.h"

namespace proveout {

/// Reports what only the whole program shows, before its first line and after its last one. Keeps references
/// to its arguments.
class ProgramNotices {
public:
    ProgramNotices(const NcText& text, const InterpretOptions& options, DialectGuess guess,
                   const Dialect& dialect, const RunState& run, const Program& program, Reporter& reporter)
        : m_text(text), m_options(options), m_guess(std::move(guess)), m_dialect(dialect), m_run(run),
          m_program(program), m_reporter(reporter) {}

    void reportBeginning();
    /// `rest`: the first line after those that were read that is not empty; the number of lines if there is
    /// none.
    void reportEnd(std::size_t rest);
    /// One message per code, at the line of its first occurrence.
    void reportIgnoredCodes();

private:
    void reportGuess();
    void reportListedButExecuted();
    void reportNeverKnown();
    void reportUnseen();

    const NcText& m_text;
    const InterpretOptions& m_options;
    const DialectGuess m_guess;
    const Dialect& m_dialect;
    const RunState& m_run;
    const Program& m_program;
    Reporter& m_reporter;
};

} // namespace proveout
