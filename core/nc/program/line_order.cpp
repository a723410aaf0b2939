// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/program/line_order.h"

#include <iterator>

namespace proveout {

LineOrder::LineOrder(const LineOrder& other, const Extent& extent, std::size_t blocks)
    : m_runs(other.m_runs), m_depth(extent.depth) {
    std::erase_if(m_runs, [&](const auto& run) { return run.second.number >= extent.runs; });
    // The other one may have been stopped before it noted that a subprogram had returned.
    for (auto& [firstLine, run] : m_runs)
        if (run.end == kUnknown)
            run.end = static_cast<std::uint32_t>(blocks);
    if (extent.firstLine == 0)
        return;
    Run& run = m_runs.at(extent.firstLine);
    run.lastLine = extent.lastLine;
    run.lastLineBlock = extent.lastLineBlock;
    run.end = kUnknown;
    m_open.push_back({extent.firstLine, 0});
}

LineOrder::Extent LineOrder::extent() const {
    Extent extent{.runs = m_runs.size(), .depth = m_depth};
    if (m_open.empty() || m_open.front().depth > 0)
        return extent;
    const auto& [firstLine, run] = *m_runs.find(m_open.front().firstLine);
    extent.firstLine = firstLine;
    extent.lastLine = run.lastLine;
    extent.lastLineBlock = run.lastLineBlock;
    return extent;
}

void LineOrder::begin(std::uint32_t line, std::size_t depth, std::size_t blocks) {
    const bool returned = m_depth > depth;
    m_depth = depth;
    while (!m_open.empty() && m_open.back().depth > depth)
        endInnermost(blocks);
    if (!m_open.empty() && m_open.back().depth == depth) {
        const auto at = m_runs.find(m_open.back().firstLine);
        const auto next = std::next(at);
        Run& run = at->second;
        if (!returned && line == run.lastLine + 1 && (next == m_runs.end() || next->first > line)) {
            run.lastLine = line;
            run.lastLineBlock = static_cast<std::uint32_t>(blocks);
            return;
        }
        endInnermost(blocks);
    }
    if (line > 0 && !isExecuted(line))
        add(line, depth, blocks);
}

LineOrder::Range LineOrder::beginOf(std::uint32_t line) const {
    const auto at = runAt(line);
    if (at == m_runs.end())
        return {kUnknown, kUnknown};
    const auto& [firstLine, run] = *at;
    if (line == run.lastLine)
        return {run.lastLineBlock, run.lastLineBlock};
    return {run.firstBlock, line > firstLine ? run.lastLineBlock : run.firstBlock};
}

LineOrder::Range LineOrder::endOf(std::uint32_t line) const {
    if (!isExecuted(line))
        return beginOf(line);
    const Run& run = runAt(line)->second;
    if (line == run.lastLine)
        return {run.end, run.end};
    return {run.firstBlock, run.lastLineBlock};
}

LineOrder::Runs::const_iterator LineOrder::runAt(std::uint32_t line) const {
    const auto after = m_runs.upper_bound(line);
    if (after == m_runs.begin())
        return after;
    const auto before = std::prev(after);
    return before->second.lastLine >= line ? before : after;
}

bool LineOrder::isExecuted(std::uint32_t line) const {
    const auto at = runAt(line);
    return at != m_runs.end() && at->first <= line;
}

void LineOrder::endInnermost(std::size_t blocks) {
    m_runs.at(m_open.back().firstLine).end = static_cast<std::uint32_t>(blocks);
    m_open.pop_back();
}

void LineOrder::add(std::uint32_t line, std::size_t depth, std::size_t blocks) {
    const auto count = static_cast<std::uint32_t>(blocks);
    m_runs.emplace(line, Run{line, count, count, kUnknown, static_cast<std::uint32_t>(m_runs.size())});
    m_open.push_back({line, depth});
}

} // namespace proveout
