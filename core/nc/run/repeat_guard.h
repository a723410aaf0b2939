// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core/nc/flow/call_stack.h"
#include "core/nc/program/program.h"
#include "core/nc/program/reporter.h"
#include "core/nc/run/repetition.h"
#include "core/nc/text/parameters.h"

namespace proveout {

/// What a program has done again so far. A value.
struct RepeatState {
    Repetition repetition;
    std::size_t reportedAgain = 0; ///< lines that were reported about though they had run before
    bool runsAgain = false;        ///< a line was reached that is before one reached earlier
};

/// Ends a program that comes back to its lines too often, so that nobody waits for its end: asked before and
/// after each line. Keeps references to its arguments.
class RepeatGuard {
public:
    RepeatGuard(const Repetition::Limits& limits, RepeatState& state, CallStack& calls,
                const Parameters& parameters, Program& program, Reporter& reporter)
        : m_limits(limits), m_state(state), m_calls(calls), m_parameters(parameters), m_program(program),
          m_reporter(reporter) {}

    /// Whether the line of the call stack may run; reported where not.
    [[nodiscard]] bool mayRun();

    /// What is remembered of a line while it runs.
    struct Started {
        bool again = false; ///< it stands before one that was reached
        std::size_t at = 0;
        std::size_t length = 0;
        std::size_t reported = 0;
    };
    /// Before it runs. `linesRead`: of the main text, up to the last one that was reached.
    [[nodiscard]] Started begin(std::size_t linesRead);
    /// After it. `depends`: what it does depends on more than parameters and the place of the program.
    void end(const Started& line, bool depends);
    /// Whether too many lines were reported about again and again, which is reported.
    [[nodiscard]] bool reportsTooOften() const;

private:
    [[nodiscard]] bool repeatsTooMuch();
    [[nodiscard]] bool goesRoundForGood();

    const Repetition::Limits m_limits;
    RepeatState& m_state;
    CallStack& m_calls;
    const Parameters& m_parameters;
    Program& m_program;
    Reporter& m_reporter;
};

} // namespace proveout
