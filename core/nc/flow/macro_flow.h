// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>

#include "core/nc/flow/call_stack.h"
#include "core/nc/program/reporter.h"
#include "core/nc/state/flow_request.h"
#include "core/nc/state/lint_memory.h"
#include "core/nc/text/expression.h"
#include "core/nc/text/macro_statement.h"

namespace proveout {

/// Executes the jumps, loops and calls of custom macro B, and its subprograms by number. Source: FANUC's
/// operator's manuals. Keeps references to its arguments.
class MacroFlow {
public:
    MacroFlow(CallStack& calls, const ReadContext& context, Reporter& reporter, LintMemory& lint)
        : m_calls(calls), m_context(context), m_reporter(reporter), m_lint(lint) {}

    enum class Next : std::uint8_t {
        line,   ///< continue with the line of the call stack
        rest,   ///< continue with the text after THEN, at rest()
        failed, ///< reported; the place to continue is unknown
    };
    /// Executes the statement of the line that the call stack has just passed.
    [[nodiscard]] Next run(const MacroStatement& statement);
    [[nodiscard]] std::size_t rest() const { return m_rest; }

    /// Whether a macro runs after every motion.
    [[nodiscard]] bool modal() const { return m_modal.has_value(); }

    /// Executes the request of a block. False, and reported, if it is not possible. A return from the main
    /// program is left to the caller unless it names a block.
    [[nodiscard]] bool run(const FlowRequest& request);
    /// Call it after a block that has moved the machine: runs the macro of G66. False, and reported, if that
    /// is not possible.
    [[nodiscard]] bool afterMotion();

private:
    struct ModalCall {
        FlowRequest request;
        std::size_t depth = 0; ///< of the macro that runs because of it; 0: it does not run
    };

    /// The file of a program that the texts do not contain.
    struct ProgramFile {
        CallStack::FileFound found;
        std::string name; ///< the name that messages propose
    };

    Next fail(const FindingRow& message, const MacroStatement& statement,
              std::vector<Argument> arguments = {});
    Next fail(const ReadError& error);
    bool refuse(const FindingRow& message, const Word& word, std::vector<Argument> arguments);

    [[nodiscard]] Next gotoBlock(const MacroStatement& statement, std::size_t at);
    [[nodiscard]] Next branch(const MacroStatement& statement);
    [[nodiscard]] Next loop(const MacroStatement& statement);
    [[nodiscard]] std::optional<bool> condition(const MacroStatement& statement, std::size_t& at);
    [[nodiscard]] bool jumpTo(long long block, const Word& word);
    [[nodiscard]] bool call(const FlowRequest& request, bool macro);
    const ProgramFile& fileOf(const FlowRequest& request, const std::string& label);
    [[nodiscard]] bool returns(const FlowRequest& request);

    CallStack& m_calls;
    const ReadContext& m_context;
    Reporter& m_reporter;
    LintMemory& m_lint;
    std::optional<ModalCall> m_modal;
    /// Files of programs that the texts do not contain. Their many possible names are searched for once, not
    /// at each call.
    std::unordered_map<std::string, ProgramFile> m_files;
    std::size_t m_rest = 0;
};

} // namespace proveout
