// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core/nc/flow/call_stack.h"
#include "core/nc/program/program.h"
#include "core/nc/program/reporter.h"
#include "core/nc/run/repetition.h"
#include "core/nc/text/parameters.h"

namespace proveout {

/// What a program has repeated. A value.
struct RepeatState {
    Repetition repetition;
    std::size_t reportedAgain = 0; ///< reports about lines that had run before
    bool runsAgain = false;        ///< a line was reached that is before one reached earlier
};

/// Ends a program that comes back to its lines too often, so that it ends in reasonable time: called before
/// and after each line. Keeps references to its arguments.
class RepeatGuard {
public:
    RepeatGuard(const Repetition::Limits& limits, RepeatState& state, CallStack& calls,
                const Parameters& parameters, Program& program, Reporter& reporter)
        : m_limits(limits), m_state(state), m_calls(calls), m_parameters(parameters), m_program(program),
          m_reporter(reporter) {}

    /// Whether the current line of the call stack may run; reported if not.
    [[nodiscard]] bool mayRun();

    /// What is remembered of a line while it runs.
    struct Started {
        bool again = false; ///< the line is before one that was already reached
        std::size_t at = 0;
        std::size_t length = 0;
        std::size_t reported = 0;
    };
    /// Call it before the line runs. `linesRead`: lines of the main text up to the last one that was reached.
    [[nodiscard]] Started begin(std::size_t linesRead);
    /// Call it after the line. `depends`: whether its effect depends on more than parameters and the position
    /// in the program.
    void end(const Started& line, bool depends);
    /// Whether too many lines were reported repeatedly, which is reported in turn.
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
