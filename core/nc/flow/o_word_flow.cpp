// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/flow/o_word_flow.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "core/nc/flow/program_files.h"
#include "core/nc/text/characters.h"

namespace proveout {

bool OWordFlow::fail(const FindingRow& message, const FlowWord& word, std::vector<Argument> arguments) {
    const auto length = static_cast<int>(std::max(word.arguments, word.begin + 1) - word.begin);
    m_reporter.report(message, static_cast<int>(word.begin + 1), length, std::move(arguments));
    return false;
}

bool OWordFlow::fail(const ReadError& error) {
    m_reporter.report(*error.message, error.column, error.length, {std::string(error.argument)});
    return false;
}

bool OWordFlow::wellFormed(const FlowWord& word) {
    const FlowLine* row = m_calls.flowIndex().at(m_calls.at());
    if (row == nullptr)
        return true;
    if (row->nested)
        return fail(nc_message::kSubNested, word, {word.label});
    if (row->twin != FlowLine::kNone)
        return fail(nc_message::kLabelTwice, word, {word.label, std::to_string(row->twin + 1)});
    return true;
}

bool OWordFlow::run(const FlowWord& word) {
    if (!wellFormed(word))
        return false;
    switch (word.kind) {
    case FlowKind::programNumber:
        return nothingBehind(word.arguments);
    case FlowKind::sub:
        return beginSub(word);
    case FlowKind::endSub:
    case FlowKind::returns:
        return endSub(word);
    case FlowKind::call:
        return call(word);
    case FlowKind::ifs:
        return branch(word);
    case FlowKind::elseIf:
    case FlowKind::elses: {
        // Reached in sequence, so the previous branch was executed.
        const auto end = partner(word, &FlowLine::end, keyword(FlowKind::endIf));
        if (end)
            m_calls.jump(*end + 1);
        return end.has_value() && conditionsReadable();
    }
    case FlowKind::endIf:
        return partner(word, &FlowLine::begin, keyword(FlowKind::ifs)).has_value();
    case FlowKind::doLoop:
        return partner(word, &FlowLine::end, keyword(FlowKind::whileLoop)).has_value();
    case FlowKind::whileLoop:
        return beginWhile(word);
    case FlowKind::endWhile:
    case FlowKind::continues:
    case FlowKind::breaks:
        return endLoop(word);
    case FlowKind::repeat:
        return beginRepeat(word);
    case FlowKind::endRepeat:
        return endRepeat(word);
    }
    return false;
}

std::optional<std::string> OWordFlow::labelOf(const FlowWord& word) {
    if (!word.label.empty())
        return word.label;
    std::size_t at = word.labelAt;
    const auto value = ExpressionReader(m_calls.currentText(), m_context).value(at, "O");
    if (!value) {
        fail(value.error());
        return {};
    }
    if (*value < 0 || *value != std::round(*value)) {
        fail(nc_message::kLabelNotWhole, word);
        return {};
    }
    return std::to_string(static_cast<long long>(*value));
}

std::optional<double> OWordFlow::bracket(const FlowWord& word, std::size_t& at) {
    const std::string_view line = m_calls.currentText();
    at = skipBlanks(line, at);
    if (at >= line.size() || line[at] != '[') {
        fail(nc_message::kFlowCondition, word, {std::string(keyword(word.kind))});
        return {};
    }
    const auto value = ExpressionReader(line, m_context).value(at, keyword(word.kind));
    if (!value) {
        fail(value.error());
        return {};
    }
    return *value;
}

bool OWordFlow::nothingBehind(std::size_t at) {
    const std::string_view line = m_calls.currentText();
    while ((at = skipBlanks(line, at)) < line.size() && line[at] == '(')
        at = std::min(line.find(')', at), line.size() - 1) + 1;
    if (at >= line.size() || line[at] == ';')
        return true;
    m_reporter.report(nc_message::kFlowRest, static_cast<int>(at + 1), 1, {std::string(line.substr(at, 1))});
    return false;
}

std::optional<bool> OWordFlow::condition(const FlowWord& word) {
    std::size_t at = word.arguments;
    const auto value = bracket(word, at);
    if (!value || !nothingBehind(at))
        return {};
    return *value != 0;
}

std::optional<std::size_t> OWordFlow::partner(const FlowWord& word, std::size_t FlowLine::*which,
                                              std::string_view missing) {
    const FlowLine* row = m_calls.flowIndex().at(m_calls.at());
    const std::size_t line = row == nullptr ? FlowLine::kNone : row->*which;
    if (line != FlowLine::kNone)
        return line;
    fail(nc_message::kFlowPartner, word, {word.label, std::string(keyword(word.kind)), std::string(missing)});
    return {};
}

bool OWordFlow::beginSub(const FlowWord& word) {
    // Calls begin after this line; reaching it in sequence skips the subprogram.
    const auto end = partner(word, &FlowLine::end, keyword(FlowKind::endSub));
    if (end)
        m_calls.jump(*end + 1);
    return end.has_value();
}

bool OWordFlow::readArguments(const FlowWord& word, Locals& arguments) {
    const std::string_view line = m_calls.currentText();
    std::size_t at = skipBlanks(line, word.arguments);
    for (std::size_t count = 0; at < line.size() && line[at] == '['; at = skipBlanks(line, at)) {
        if (count == kMostArguments)
            return fail(nc_message::kTooManyArguments, word);
        const auto value = bracket(word, at);
        if (!value)
            return false;
        arguments[count++] = *value;
    }
    return nothingBehind(at);
}

bool OWordFlow::call(const FlowWord& word) {
    const auto label = labelOf(word);
    Locals arguments = m_parameters.noArguments();
    if (!label || !readArguments(word, arguments))
        return false;
    CallStack::Source* source = &m_calls.source();
    std::size_t entry = m_calls.flowIndex().sub(*label);
    if (entry == FlowLine::kNone) {
        source = fileOf(*label, word);
        if (source == nullptr)
            return false;
        entry = source->flow->sub(*label);
        if (entry == FlowLine::kNone)
            return fail(nc_message::kSubUnknown, word, {*label, source->file});
    }
    if (!m_calls.mayCall())
        return fail(nc_message::kCallTooDeep, word,
                    {std::to_string(m_calls.deepest()), m_calls.chain(*label)});
    CallStack::Level level;
    level.entry = entry + 1;
    level.label = *label;
    m_calls.enter(*source, std::move(level), arguments);
    return true;
}

bool OWordFlow::endSub(const FlowWord& word) {
    if (m_calls.inMainProgram() || m_calls.level().repeats)
        return fail(nc_message::kReturnOutside, word, {std::string(keyword(word.kind))});
    std::size_t at = skipBlanks(m_calls.currentText(), word.arguments);
    const bool given = at < m_calls.currentText().size() && m_calls.currentText()[at] == '[';
    const std::optional<double> value = given ? bracket(word, at) : std::nullopt;
    const bool readable = given == value.has_value() && nothingBehind(at);
    // The subprogram ends here, whatever the value: the following lines do not belong to it.
    m_calls.leave();
    // The names are defined by LinuxCNC.
    return readable && m_parameters.setNamed("_value", value.value_or(0)) &&
           m_parameters.setNamed("_value_returned", value ? 1 : 0);
}

bool OWordFlow::branch(const FlowWord& word) {
    if (!partner(word, &FlowLine::end, keyword(FlowKind::endIf)))
        return false;
    auto taken = condition(word);
    const FlowLine* row = m_calls.flowIndex().at(m_calls.at());
    while (taken && !*taken) {
        const std::size_t next = row->next;
        row = m_calls.flowIndex().at(next);
        m_calls.jump(next + 1);
        if (row->kind != FlowKind::elseIf)
            return true;
        m_calls.moveTo(next);
        const auto elseIf = readFlowWord(m_calls.currentText());
        taken = elseIf ? condition(*elseIf) : std::nullopt;
    }
    return taken.has_value();
}

/// LinuxCNC also evaluates the conditions that it skips, and stops if it cannot.
bool OWordFlow::conditionsReadable() {
    const FlowLine* row = m_calls.flowIndex().at(m_calls.at());
    while (row != nullptr) {
        if (row->kind == FlowKind::elseIf) {
            m_calls.moveTo(row->line);
            const auto word = readFlowWord(m_calls.currentText());
            if (!word || !condition(*word))
                return false;
        }
        row = row->kind == FlowKind::endIf ? nullptr : m_calls.flowIndex().at(row->next);
    }
    return true;
}

bool OWordFlow::beginWhile(const FlowWord& word) {
    const FlowLine* row = m_calls.flowIndex().at(m_calls.at());
    const bool closesDo = row != nullptr && row->closesDo;
    const auto end = partner(word, &FlowLine::end, keyword(FlowKind::endWhile));
    const auto again = end ? condition(word) : std::nullopt;
    if (!again)
        return false;
    if (closesDo && *again)
        m_calls.jump(row->begin + 1);
    else if (!closesDo && !*again)
        m_calls.jump(*end + 1);
    return true;
}

bool OWordFlow::endLoop(const FlowWord& word) {
    const auto begin = partner(word, &FlowLine::begin, keyword(FlowKind::whileLoop));
    if (!begin || !nothingBehind(word.arguments))
        return false;
    const FlowLine& loop = *m_calls.flowIndex().at(*begin);
    if (word.kind == FlowKind::breaks)
        m_calls.jump(loop.end + 1);
    else if (word.kind == FlowKind::endWhile || loop.kind == FlowKind::whileLoop)
        m_calls.jump(loop.line);
    else
        continueDo(word, loop);
    return true;
}

/// In this case LinuxCNC executes twice a "repeat" that it reaches, but not every one.
void OWordFlow::continueDo(const FlowWord& word, const FlowLine& loop) {
    const bool mayRepeat = m_calls.flowIndex().repeats() || !m_calls.inMainText();
    if (mayRepeat && !m_calls.isAgain())
        fail(nc_message::kContinueInDo, word);
    m_calls.jump(loop.end);
}

bool OWordFlow::beginRepeat(const FlowWord& word) {
    const auto end = partner(word, &FlowLine::end, keyword(FlowKind::endRepeat));
    std::size_t at = word.arguments;
    const auto rounds = end ? bracket(word, at) : std::nullopt;
    if (!rounds || !nothingBehind(at))
        return false;
    if (*rounds < 0.5) {
        m_calls.jump(*end + 1);
        return leaveRepeat(m_calls.at());
    }
    if (*rounds > static_cast<double>(kMostRounds))
        return fail(nc_message::kTooManyRounds, word,
                    {fmt::format("{:.0f}", *rounds), std::to_string(kMostRounds)});
    m_calls.noteRound();
    m_calls.counts()[m_calls.at()] = static_cast<std::uint64_t>(std::llround(*rounds));
    return true;
}

bool OWordFlow::endRepeat(const FlowWord& word) {
    const auto begin = partner(word, &FlowLine::begin, keyword(FlowKind::repeat));
    if (!begin)
        return false;
    const auto rounds = m_calls.counts().find(*begin);
    m_calls.noteRound();
    if (rounds != m_calls.counts().end() && --rounds->second > 0) {
        m_calls.jump(*begin + 1);
        return true;
    }
    return leaveRepeat(*begin);
}

/// In this case LinuxCNC searches for the end of the loop, and refuses a break or continue with its label on
/// the way.
bool OWordFlow::leaveRepeat(std::size_t begin) {
    const FlowLine* row = m_calls.flowIndex().at(begin);
    if (row == nullptr || row->jump == FlowLine::kNone)
        return true;
    m_calls.moveTo(row->jump);
    const auto word = readFlowWord(m_calls.currentText());
    return !word ||
           fail(nc_message::kFlowPartner, *word,
                {word->label, std::string(keyword(word->kind)), std::string(keyword(FlowKind::whileLoop))});
}

bool OWordFlow::run(const FlowRequest& request) {
    const auto fail = [&](const FindingRow& message, std::vector<Argument> arguments) {
        m_reporter.report(message, request.word, std::move(arguments));
        return false;
    };
    if (request.kind == FlowRequest::Kind::none)
        return true;
    if (request.kind == FlowRequest::Kind::returns) {
        if (m_calls.inMainProgram())
            return true;
        if (!m_calls.level().repeats)
            return fail(nc_message::kReturnOutside, {"M99"});
        if (int& repeats = *m_calls.level().repeats; --repeats > 0)
            m_calls.again(false);
        else
            m_calls.leave();
        return true;
    }
    const std::string label = std::to_string(request.program);
    const std::size_t entry = m_calls.flowIndex().program(label);
    if (entry == FlowLine::kNone)
        return fail(nc_message::kSubUnknown, {label, subFileName(label)});
    if (!m_calls.mayCall())
        return fail(nc_message::kCallTooDeep, {std::to_string(m_calls.deepest()), m_calls.chain(label)});
    if (request.repeats == 0)
        return true;
    if (request.repeats > kMostRounds)
        return fail(nc_message::kTooManyRounds,
                    {std::to_string(request.repeats), std::to_string(kMostRounds)});
    CallStack::Level level;
    level.entry = entry + 1;
    level.label = label;
    level.repeats = request.repeats;
    level.sharesNumbers = true;
    m_calls.enter(m_calls.source(), std::move(level), m_parameters.noArguments());
    return true;
}

CallStack::Source* OWordFlow::fileOf(const std::string& label, const FlowWord& word) {
    const std::string name = subFileName(label);
    const CallStack::FileFound found = name.empty()
                                           ? CallStack::FileFound{nullptr, CallStack::FileFault::outside, {}}
                                           : m_calls.file({name});
    switch (found.fault) {
    case CallStack::FileFault::none:
        if (!found.source->flow)
            found.source->flow.emplace(found.source->text);
        return found.source;
    case CallStack::FileFault::outside:
        fail(nc_message::kSubFolder, word, {label});
        return nullptr;
    case CallStack::FileFault::unreadable:
        fail(nc_message::kSubUnreadable, word, {name, found.reason});
        return nullptr;
    case CallStack::FileFault::unknown:
        fail(nc_message::kSubUnknown, word, {label, name});
        return nullptr;
    }
    return nullptr;
}

} // namespace proveout
