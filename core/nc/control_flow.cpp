// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/control_flow.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/nc/characters.h"

namespace proveout {

namespace {

constexpr std::string_view kExtension = ".ngc";

/// Whether a label may name a file within a folder.
bool plainName(std::string_view label) {
    return label.find_first_of("/\\") == std::string_view::npos && !label.starts_with('.');
}

} // namespace

ControlFlow::ControlFlow(const NcText& main, std::string file, const Limits& limits, Parameters& parameters,
                         const SystemValues& system, Reporter& reporter)
    : m_limits(limits), m_parameters(parameters), m_system(system), m_reporter(reporter) {
    m_sources.push_back(std::make_unique<Source>(Source{main, std::move(file), {}}));
    m_source = m_sources.front().get();
}

std::size_t ControlFlow::mainLine() const {
    const Source* main = m_sources.front().get();
    if (m_source == main)
        return m_at;
    const auto caller = std::ranges::find(m_levels.rbegin(), m_levels.rend(), main, &Level::source);
    return caller->line - 1;
}

bool ControlFlow::step() {
    m_at = m_line++;
    if (++m_steps <= m_limits.maxSteps)
        return true;
    m_reporter.tellInAnyCase(nc_message::kTooManySteps, 1, 0,
                             {std::to_string(m_limits.maxSteps), linesOfCalls()});
    return false;
}

const FlowIndex& ControlFlow::index() {
    if (!m_source->index)
        m_source->index.emplace(m_source->text);
    return *m_source->index;
}

bool ControlFlow::fail(const Message& message, const FlowWord& word, std::vector<std::string> arguments) {
    const auto length = static_cast<int>(std::max(word.arguments, word.begin + 1) - word.begin);
    m_reporter.tell(message, static_cast<int>(word.begin + 1), length, std::move(arguments));
    return false;
}

bool ControlFlow::fail(const ReadError& error) {
    m_reporter.tell(*error.message, error.column, error.length, {std::string(error.argument)});
    return false;
}

bool ControlFlow::wellFormed(const FlowWord& word) {
    const FlowLine* row = index().at(m_at);
    if (row == nullptr)
        return true;
    if (row->nested)
        return fail(nc_message::kSubNested, word, {word.label});
    if (row->twin != FlowLine::kNone)
        return fail(nc_message::kLabelTwice, word, {word.label, std::to_string(row->twin + 1)});
    return true;
}

bool ControlFlow::run(const FlowWord& word) {
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
        // Reached by running: the branch before it was taken.
        const auto end = partner(word, &FlowLine::end, keyword(FlowKind::endIf));
        if (end)
            m_line = *end + 1;
        return end.has_value();
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

std::optional<std::string> ControlFlow::labelOf(const FlowWord& word) {
    if (!word.label.empty())
        return word.label;
    std::size_t at = word.labelAt;
    const auto value = ExpressionReader(currentText(), m_parameters, m_system).value(at, "O");
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

std::optional<double> ControlFlow::bracket(const FlowWord& word, std::size_t& at) {
    const std::string_view line = currentText();
    at = skipBlanks(line, at);
    if (at >= line.size() || line[at] != '[') {
        fail(nc_message::kFlowCondition, word, {std::string(keyword(word.kind))});
        return {};
    }
    const auto value = ExpressionReader(line, m_parameters, m_system).value(at, keyword(word.kind));
    if (!value) {
        fail(value.error());
        return {};
    }
    return *value;
}

bool ControlFlow::nothingBehind(std::size_t at) {
    const std::string_view line = currentText();
    while ((at = skipBlanks(line, at)) < line.size() && line[at] == '(')
        at = std::min(line.find(')', at), line.size() - 1) + 1;
    if (at >= line.size() || line[at] == ';')
        return true;
    m_reporter.tell(nc_message::kFlowRest, static_cast<int>(at + 1), 1, {std::string(line.substr(at, 1))});
    return false;
}

std::optional<bool> ControlFlow::condition(const FlowWord& word) {
    std::size_t at = word.arguments;
    const auto value = bracket(word, at);
    if (!value || !nothingBehind(at))
        return {};
    return *value != 0;
}

std::optional<std::size_t> ControlFlow::partner(const FlowWord& word, std::size_t FlowLine::*which,
                                                std::string_view missing) {
    const FlowLine* row = index().at(m_at);
    const std::size_t line = row == nullptr ? FlowLine::kNone : row->*which;
    if (line != FlowLine::kNone)
        return line;
    fail(nc_message::kFlowPartner, word, {word.label, std::string(keyword(word.kind)), std::string(missing)});
    return {};
}

bool ControlFlow::beginSub(const FlowWord& word) {
    // Calls begin behind this line; who comes here by running passes the subprogram over.
    const auto end = partner(word, &FlowLine::end, keyword(FlowKind::endSub));
    if (end)
        m_line = *end + 1;
    return end.has_value();
}

bool ControlFlow::readArguments(const FlowWord& word, Locals& arguments) {
    const std::string_view line = currentText();
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

bool ControlFlow::call(const FlowWord& word) {
    const auto label = labelOf(word);
    Locals arguments{};
    if (!label || !readArguments(word, arguments))
        return false;
    Source* source = m_source;
    std::size_t entry = index().sub(*label);
    if (entry == FlowLine::kNone) {
        source = fileOf(*label, word);
        if (source == nullptr)
            return false;
        entry = source->index->sub(*label);
        if (entry == FlowLine::kNone)
            return fail(nc_message::kSubUnknown, word, {*label, source->file});
    }
    if (m_levels.size() == kDeepest)
        return fail(nc_message::kCallTooDeep, word, {std::to_string(kDeepest), chain(*label)});
    Level level;
    level.label = *label;
    return enter(*source, entry + 1, std::move(level), arguments);
}

bool ControlFlow::enter(Source& source, std::size_t entry, Level level, const Locals& arguments) {
    level.source = m_source;
    level.line = m_line;
    level.entry = entry;
    level.counts = std::exchange(m_counts, {});
    m_levels.push_back(std::move(level));
    m_parameters.enter(arguments);
    m_source = &source;
    m_line = entry;
    m_reporter.setFile(m_source->file);
    return true;
}

void ControlFlow::leave() {
    ++m_endedRuns;
    Level& level = m_levels.back();
    m_source = level.source;
    m_line = level.line;
    m_counts = std::move(level.counts);
    m_levels.pop_back();
    m_parameters.leave();
    m_reporter.setFile(m_source->file);
}

bool ControlFlow::leaveFile() {
    if (m_levels.empty())
        return false;
    m_reporter.tell(nc_message::kSubEndMissing, 1, 0, {m_levels.back().label});
    leave();
    return true;
}

bool ControlFlow::endSub(const FlowWord& word) {
    if (m_levels.empty() || m_levels.back().repeats)
        return fail(nc_message::kReturnOutside, word, {std::string(keyword(word.kind))});
    std::size_t at = skipBlanks(currentText(), word.arguments);
    std::optional<double> value;
    if (at < currentText().size() && currentText()[at] == '[') {
        value = bracket(word, at);
        if (!value)
            return false;
    }
    if (!nothingBehind(at))
        return false;
    leave();
    // The names are LinuxCNC's.
    return m_parameters.setNamed("_value", value.value_or(0)) &&
           m_parameters.setNamed("_value_returned", value ? 1 : 0);
}

bool ControlFlow::branch(const FlowWord& word) {
    if (!partner(word, &FlowLine::end, keyword(FlowKind::endIf)))
        return false;
    auto taken = condition(word);
    const FlowLine* row = index().at(m_at);
    while (taken && !*taken) {
        const std::size_t next = row->next;
        row = index().at(next);
        m_line = next + 1;
        if (row->kind != FlowKind::elseIf)
            return true;
        m_at = next;
        m_reporter.beginLine(static_cast<std::uint32_t>(next + 1));
        const auto elseIf = readFlowWord(currentText());
        taken = elseIf ? condition(*elseIf) : std::nullopt;
    }
    return taken.has_value();
}

bool ControlFlow::beginWhile(const FlowWord& word) {
    const FlowLine* row = index().at(m_at);
    const bool closesDo = row != nullptr && row->closesDo;
    const auto end = partner(word, &FlowLine::end, keyword(FlowKind::endWhile));
    const auto again = end ? condition(word) : std::nullopt;
    if (!again)
        return false;
    if (closesDo && *again)
        m_line = row->begin + 1;
    else if (!closesDo && !*again)
        m_line = *end + 1;
    return true;
}

bool ControlFlow::endLoop(const FlowWord& word) {
    const auto begin = partner(word, &FlowLine::begin, keyword(FlowKind::whileLoop));
    if (!begin || !nothingBehind(word.arguments))
        return false;
    const FlowLine& loop = *index().at(*begin);
    if (word.kind == FlowKind::breaks)
        m_line = loop.end + 1;
    else if (word.kind == FlowKind::endWhile || loop.kind == FlowKind::whileLoop)
        m_line = loop.line;
    else
        m_line = loop.end;
    return true;
}

bool ControlFlow::beginRepeat(const FlowWord& word) {
    const auto end = partner(word, &FlowLine::end, keyword(FlowKind::endRepeat));
    std::size_t at = word.arguments;
    const auto rounds = end ? bracket(word, at) : std::nullopt;
    if (!rounds || !nothingBehind(at))
        return false;
    if (*rounds < 0.5) {
        m_line = *end + 1;
        return true;
    }
    m_counts[m_at] = static_cast<std::uint64_t>(std::llround(*rounds));
    return true;
}

bool ControlFlow::endRepeat(const FlowWord& word) {
    const auto begin = partner(word, &FlowLine::begin, keyword(FlowKind::repeat));
    if (!begin)
        return false;
    const auto rounds = m_counts.find(*begin);
    if (rounds != m_counts.end() && --rounds->second > 0)
        m_line = *begin + 1;
    return true;
}

bool ControlFlow::run(const FlowRequest& request) {
    const auto fail = [&](const Message& message, std::vector<std::string> arguments) {
        m_reporter.tell(message, request.word, std::move(arguments));
        return false;
    };
    if (request.kind == FlowRequest::Kind::none)
        return true;
    if (request.kind == FlowRequest::Kind::returns) {
        if (m_levels.empty())
            return true;
        if (!m_levels.back().repeats)
            return fail(nc_message::kReturnOutside, {"M99"});
        if (int& repeats = *m_levels.back().repeats; --repeats > 0) {
            ++m_endedRuns;
            m_line = m_levels.back().entry;
        } else {
            leave();
        }
        return true;
    }
    const std::string label = std::to_string(request.program);
    const std::size_t entry = index().program(label);
    if (entry == FlowLine::kNone)
        return fail(nc_message::kSubUnknown, {label, label + std::string(kExtension)});
    if (m_levels.size() == kDeepest)
        return fail(nc_message::kCallTooDeep, {std::to_string(kDeepest), chain(label)});
    if (request.repeats == 0)
        return true;
    Level level;
    level.label = label;
    level.repeats = request.repeats;
    return enter(*m_source, entry + 1, std::move(level), {});
}

ControlFlow::Source* ControlFlow::fileOf(const std::string& label, const FlowWord& word) {
    const std::string name = label + std::string(kExtension);
    if (!plainName(label)) {
        fail(nc_message::kSubFolder, word, {label});
        return nullptr;
    }
    for (const std::filesystem::path& given : m_limits.folders) {
        const std::filesystem::path folder = given.empty() ? "." : given;
        const std::filesystem::path path = folder / name;
        const auto known = std::ranges::find(m_sources, path.string(), [](const auto& s) { return s->file; });
        if (known != m_sources.end())
            return known->get();
        std::error_code error;
        if (!std::filesystem::is_regular_file(path, error))
            continue;
        // A link may lead anywhere.
        const auto inside = std::filesystem::relative(path, folder, error);
        if (error || inside.empty() || inside.string().starts_with("..")) {
            fail(nc_message::kSubFolder, word, {label});
            return nullptr;
        }
        Result<NcText> text = NcText::load(path);
        if (!text) {
            fail(nc_message::kSubUnreadable, word, {name, text.error().front().text});
            return nullptr;
        }
        m_sources.push_back(std::make_unique<Source>(Source{std::move(*text), path.string(), {}}));
        m_sources.back()->index.emplace(m_sources.back()->text);
        return m_sources.back().get();
    }
    fail(nc_message::kSubUnknown, word, {label, name});
    return nullptr;
}

std::string ControlFlow::chain(const std::string& last) const {
    std::string names;
    for (const Level& level : m_levels)
        names += (names.empty() ? "" : " > ") + level.label;
    return names + " > " + last;
}

std::string ControlFlow::linesOfCalls() const {
    std::string lines;
    for (const Level& level : m_levels)
        lines += std::to_string(level.line) + " (O" + level.label + ") > ";
    return lines + std::to_string(m_at + 1);
}

} // namespace proveout
