// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "core/nc/flow/call_stack.h"
#include "core/nc/program/reporter.h"
#include "core/nc/state/flow_request.h"
#include "core/nc/text/expression.h"
#include "core/nc/text/flow_word.h"

namespace proveout {

/// Executes the subprograms, branches and loops of LinuxCNC. Source: its documentation of O-codes. Keeps
/// references to its arguments.
class OWordFlow {
public:
    static constexpr std::size_t kMostArguments = 30; ///< of a call
    static constexpr int kMostRounds = 1'000'000;     ///< of a repeat, or a call

    OWordFlow(CallStack& calls, Parameters& parameters, const ReadContext& context, Reporter& reporter)
        : m_calls(calls), m_parameters(parameters), m_context(context), m_reporter(reporter) {}

    /// Executes the O-word of the line that the call stack has just passed. False, and reported, if it is not
    /// possible.
    [[nodiscard]] bool run(const FlowWord& word);
    /// Executes the request of a block. False, and reported, if it is not possible. A return from the main
    /// program is left to the caller.
    [[nodiscard]] bool run(const FlowRequest& request);

private:
    using Locals = Parameters::Locals;

    bool fail(const FindingRow& message, const FlowWord& word, std::vector<Argument> arguments = {});
    bool fail(const ReadError& error);

    [[nodiscard]] bool wellFormed(const FlowWord& word);
    [[nodiscard]] std::optional<std::string> labelOf(const FlowWord& word);
    [[nodiscard]] std::optional<double> bracket(const FlowWord& word, std::size_t& at);
    [[nodiscard]] bool nothingBehind(std::size_t at);
    [[nodiscard]] std::optional<bool> condition(const FlowWord& word);
    [[nodiscard]] bool conditionsReadable();
    [[nodiscard]] std::optional<std::size_t> partner(const FlowWord& word, std::size_t FlowLine::*which,
                                                     std::string_view missing);

    bool beginSub(const FlowWord& word);
    bool call(const FlowWord& word);
    bool readArguments(const FlowWord& word, Locals& arguments);
    bool endSub(const FlowWord& word);
    bool branch(const FlowWord& word);
    bool beginWhile(const FlowWord& word);
    bool endLoop(const FlowWord& word);
    void continueDo(const FlowWord& word, const FlowLine& loop);
    bool beginRepeat(const FlowWord& word);
    bool leaveRepeat(std::size_t begin);
    bool endRepeat(const FlowWord& word);
    CallStack::Source* fileOf(const std::string& label, const FlowWord& word);

    CallStack& m_calls;
    Parameters& m_parameters;
    const ReadContext& m_context;
    Reporter& m_reporter;
};

} // namespace proveout
