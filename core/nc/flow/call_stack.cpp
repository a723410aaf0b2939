// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/flow/call_stack.h"

#include <algorithm>
#include <utility>

namespace proveout {

CallStack::CallStack(const NcText& main, std::string file, const Limits& limits, Parameters& parameters,
                     Reporter& reporter)
    : m_limits(limits), m_parameters(parameters), m_reporter(reporter) {
    m_sources.push_back(std::make_unique<Source>(Source{main, std::move(file), {}, {}, 0, {}}));
    m_source = m_sources.front().get();
}

std::size_t CallStack::mainLine() const {
    const Source* main = m_sources.front().get();
    if (m_source == main)
        return m_at;
    const auto caller = std::ranges::find(m_levels.rbegin(), m_levels.rend(), main, &Level::source);
    return caller->line - 1;
}

const FlowIndex& CallStack::flowIndex() {
    m_indexAsked = true;
    if (!m_source->flow)
        m_source->flow.emplace(m_source->text);
    return *m_source->flow;
}

const MacroIndex& CallStack::macroIndex(Source& source) {
    m_indexAsked = true;
    if (!source.macro)
        source.macro.emplace(source.text);
    return *source.macro;
}

std::optional<CallStack::Place> CallStack::place() const {
    if (!m_levels.empty() || m_filesAsked)
        return {};
    return Place{m_line, m_source->reached, m_endedRuns, m_roundsCounted, m_counts, m_indexAsked};
}

void CallStack::continueAt(const Place& place) {
    m_line = place.line;
    m_at = place.line > 0 ? place.line - 1 : 0;
    m_source->reached = place.reached;
    m_endedRuns = place.endedRuns;
    m_roundsCounted = place.roundsCounted;
    m_counts = place.counts;
    m_indexAsked = place.indexAsked;
}

void CallStack::step() {
    m_at = m_line++;
    Reached& all = m_source->reached;
    std::size_t& reached = m_levels.empty() ? all.inProgram : all.inCalls;
    m_again = m_at < reached;
    reached = std::max(reached, m_line);
}

void CallStack::enter(Source& source, Level level, const Parameters::Locals& arguments) {
    level.source = m_source;
    level.line = m_line;
    level.counts = std::exchange(m_counts, {});
    m_source = &source;
    m_line = level.entry;
    if (level.sharesNumbers)
        m_parameters.enterSharing();
    else if (level.ownLocals)
        m_parameters.enter(arguments);
    m_levels.push_back(std::move(level));
    m_reporter.setFile(m_source->file);
}

void CallStack::again(bool withArguments) {
    ++m_endedRuns;
    noteRound();
    const Level& level = m_levels.back();
    m_line = level.entry;
    if (!level.ownLocals || !withArguments)
        return;
    m_parameters.leave();
    m_parameters.enter(level.arguments);
}

void CallStack::leave() {
    ++m_endedRuns;
    Level& level = m_levels.back();
    m_source = level.source;
    m_line = level.line;
    m_counts = std::move(level.counts);
    if (level.sharesNumbers)
        m_parameters.leaveSharing();
    else if (level.ownLocals)
        m_parameters.leave();
    m_levels.pop_back();
    m_lowestDepth = std::min(m_lowestDepth, m_levels.size());
    m_reporter.setFile(m_source->file);
}

CallStack::FileFound CallStack::file(const std::vector<std::string>& names) {
    m_filesAsked = true;
    for (const std::filesystem::path& given : m_limits.folders) {
        const std::filesystem::path folder = given.empty() ? "." : given;
        for (const std::string& name : names) {
            const std::filesystem::path path = folder / name;
            const auto known =
                std::ranges::find(m_sources, path.string(), [](const auto& s) { return s->file; });
            if (known != m_sources.end())
                return {known->get(), FileFault::none, {}};
            std::error_code error;
            if (!std::filesystem::is_regular_file(path, error))
                continue;
            // A link may lead anywhere.
            const auto inside = std::filesystem::relative(path, folder, error);
            if (error || inside.empty() || inside.string().starts_with(".."))
                return {nullptr, FileFault::outside, {}};
            Result<NcText> text = NcText::load(path);
            if (!text)
                return {nullptr, FileFault::unreadable, text.error().front().text};
            m_sources.push_back(std::make_unique<Source>(
                Source{std::move(*text), path.string(), {}, {}, m_sources.size(), {}}));
            return {m_sources.back().get(), FileFault::none, {}};
        }
    }
    return {nullptr, FileFault::unknown, {}};
}

std::string CallStack::chain(const std::string& last) const {
    std::string names;
    for (const Level& level : m_levels)
        names += (names.empty() ? "" : " > ") + level.label;
    return names + " > " + last;
}

std::string CallStack::linesOfCalls() const {
    std::string lines;
    for (const Level& level : m_levels)
        lines += std::to_string(level.line) + " (O" + level.label + ") > ";
    return lines + std::to_string(m_at + 1);
}

} // namespace proveout
