// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/flow/macro_flow.h"

#include <cmath>
#include <fmt/format.h>

#include "core/nc/flow/program_files.h"
#include "core/nc/text/characters.h"

namespace proveout {

namespace {

constexpr double kMostNumber = 99'999'999; ///< of blocks and programs

const MacroIndex::Range* programIn(const MacroIndex& index, const FlowRequest& request) {
    return request.name.empty() ? index.program(request.program) : index.program(request.name);
}

} // namespace

MacroFlow::Next MacroFlow::fail(const FindingRow& message, const MacroStatement& statement,
                                std::vector<Argument> arguments) {
    m_reporter.report(message, static_cast<int>(statement.begin + 1),
                      static_cast<int>(statement.rest - statement.begin), std::move(arguments));
    return Next::failed;
}

MacroFlow::Next MacroFlow::fail(const ReadError& error) {
    m_reporter.report(*error.message, error.column, error.length, {std::string(error.argument)});
    return Next::failed;
}

bool MacroFlow::refuse(const FindingRow& message, const Word& word, std::vector<Argument> arguments) {
    m_reporter.report(message, word, std::move(arguments));
    return false;
}

MacroFlow::Next MacroFlow::run(const MacroStatement& statement) {
    switch (statement.kind) {
    case StatementKind::gotoBlock:
        return gotoBlock(statement, statement.rest);
    case StatementKind::ifs:
        return branch(statement);
    case StatementKind::whileLoop:
    case StatementKind::doLoop:
    case StatementKind::endLoop:
        return loop(statement);
    case StatementKind::output:
        return Next::line;
    }
    return Next::failed;
}

MacroFlow::Next MacroFlow::gotoBlock(const MacroStatement& statement, std::size_t at) {
    const auto value = ExpressionReader(m_calls.currentText(), m_context).value(at, "GOTO");
    if (!value)
        return fail(value.error());
    if (!(*value >= 0 && *value <= kMostNumber) || *value != std::round(*value))
        return fail(nc_message::kBlockTarget, statement);
    const Word word{'N', *value, static_cast<int>(statement.begin + 1),
                    static_cast<int>(at - statement.begin)};
    return jumpTo(static_cast<long long>(*value), word) ? Next::line : Next::failed;
}

bool MacroFlow::jumpTo(long long block, const Word& word) {
    const std::size_t line = m_calls.macroIndex().block(block, m_calls.at());
    if (line == MacroIndex::kNone)
        return refuse(nc_message::kBlockUnknown, word, {std::to_string(block)});
    if (m_calls.macroIndex().repeated(block, m_calls.at()) &&
        m_lint.ambiguousJumps.insert(m_calls.at()).second)
        m_reporter.report(nc_message::kBlockTwice, word, {std::to_string(block), std::to_string(line + 1)});
    m_calls.jump(line);
    return true;
}

std::optional<bool> MacroFlow::condition(const MacroStatement& statement, std::size_t& at) {
    const std::string_view line = m_calls.currentText();
    at = skipBlanks(line, at);
    if (at >= line.size() || line[at] != '[') {
        fail(nc_message::kStatementForm, statement);
        return {};
    }
    const auto value = ExpressionReader(line, m_context).value(at, "IF");
    if (!value) {
        fail(value.error());
        return {};
    }
    return !isNull(*value) && *value != 0;
}

MacroFlow::Next MacroFlow::branch(const MacroStatement& statement) {
    std::size_t at = statement.rest;
    const auto taken = condition(statement, at);
    if (!taken)
        return Next::failed;
    const bool jumps = readKeyword(m_calls.currentText(), at, "GOTO");
    if (!jumps && !readKeyword(m_calls.currentText(), at, "THEN"))
        return fail(nc_message::kStatementForm, statement);
    if (!*taken)
        return Next::line;
    if (jumps)
        return gotoBlock(statement, at);
    m_rest = at;
    return Next::rest;
}

MacroFlow::Next MacroFlow::loop(const MacroStatement& statement) {
    const std::size_t partner = m_calls.macroIndex().partner(m_calls.at());
    if (partner == MacroIndex::kNone)
        return fail(nc_message::kLoopPartner, statement,
                    {std::string(statement.kind == StatementKind::endLoop ? "DO" : "END")});
    if (statement.kind == StatementKind::endLoop) {
        m_calls.jump(partner);
        return Next::line;
    }
    if (statement.kind == StatementKind::doLoop)
        return Next::line;
    std::size_t at = statement.rest;
    // A condition that cannot be read would make the loop endless.
    const auto again = condition(statement, at);
    if (!again || !*again)
        m_calls.jump(partner + 1);
    return again ? Next::line : Next::failed;
}

bool MacroFlow::run(const FlowRequest& request) {
    switch (request.kind) {
    case FlowRequest::Kind::none:
        return true;
    case FlowRequest::Kind::call:
        return call(request, false);
    case FlowRequest::Kind::macro:
        return call(request, true);
    case FlowRequest::Kind::callLocal: {
        const std::size_t entry = m_calls.macroIndex().block(request.program, m_calls.at());
        if (entry == MacroIndex::kNone)
            return refuse(nc_message::kBlockUnknown, request.word, {std::to_string(request.program)});
        CallStack::Level level;
        level.entry = entry;
        level.label = fmt::format("N{}", request.program);
        level.repeats = request.repeats;
        level.ownLocals = false;
        if (!m_calls.mayCall())
            return refuse(nc_message::kCallTooDeep, request.word,
                          {std::to_string(m_calls.deepest()), m_calls.chain(level.label)});
        if (request.repeats > 0)
            m_calls.enter(m_calls.source(), std::move(level), {});
        return true;
    }
    case FlowRequest::Kind::modalMacro:
        m_modal = ModalCall{request, 0};
        // Errors from here on concern another line.
        m_modal->request.word.column = 1;
        m_modal->request.word.length = 0;
        return true;
    case FlowRequest::Kind::cancelModal:
        m_modal.reset();
        return true;
    case FlowRequest::Kind::returns:
        return returns(request);
    }
    return false;
}

bool MacroFlow::call(const FlowRequest& request, bool macro) {
    const std::string label = request.name.empty() ? std::to_string(request.program) : request.name;
    if (!m_calls.mayCall())
        return refuse(nc_message::kCallTooDeep, request.word,
                      {std::to_string(m_calls.deepest()), m_calls.chain(label)});
    CallStack::Source* source = &m_calls.source();
    const MacroIndex::Range* program = programIn(m_calls.macroIndex(), request);
    if (program == nullptr) {
        const auto& [found, name] = fileOf(request, label);
        if (found.source == nullptr && found.fault == CallStack::FileFault::unreadable)
            return refuse(nc_message::kSubUnreadable, request.word, {label, found.reason});
        if (found.source == nullptr)
            return refuse(nc_message::kSubUnknown, request.word, {label, name});
        source = found.source;
        const MacroIndex& index = m_calls.macroIndex(*source);
        program = programIn(index, request);
        // The file with that name is the program, whatever it contains.
        if (program == nullptr && !request.name.empty())
            program = &index.programOf(0);
    }
    CallStack::Level level;
    level.entry = program == nullptr ? 0 : program->first;
    level.label = label;
    level.repeats = request.repeats;
    level.ownLocals = macro;
    level.arguments = request.arguments;
    if (request.repeats > 0)
        m_calls.enter(*source, std::move(level), request.arguments);
    return true;
}

const MacroFlow::ProgramFile& MacroFlow::fileOf(const FlowRequest& request, const std::string& label) {
    // A number and a name may look the same.
    const std::string key = (request.name.empty() ? "O" : "<") + label;
    const auto [file, isNew] = m_files.try_emplace(key);
    if (isNew) {
        const std::vector<std::string> names = macroFileNames(request.program, request.name);
        file->second = {m_calls.file(names), names.front()};
    }
    return file->second;
}

bool MacroFlow::returns(const FlowRequest& request) {
    if (m_calls.inMainProgram())
        return request.program == 0 || jumpTo(request.program, request.word);
    CallStack::Level& level = m_calls.level();
    if (request.program == 0 && level.repeats && *level.repeats > 1) {
        --*level.repeats;
        m_calls.again(true);
        return true;
    }
    if (m_modal && m_modal->depth == m_calls.depth())
        m_modal->depth = 0;
    if (request.program == 0) {
        m_calls.leave();
        return true;
    }
    // Reported here, at the block that returns.
    const std::size_t line = m_calls.macroIndex(*level.source).block(request.program, level.line - 1);
    const bool found = line != MacroIndex::kNone ||
                       refuse(nc_message::kBlockUnknown, request.word, {std::to_string(request.program)});
    m_calls.leave();
    if (found)
        m_calls.jump(line);
    return found;
}

bool MacroFlow::afterMotion() {
    // A macro that runs because of G66 is not called again by its own motions.
    if (!m_modal || m_modal->depth != 0)
        return true;
    if (!call(m_modal->request, true))
        return false;
    m_modal->depth = m_calls.depth();
    return true;
}

} // namespace proveout
