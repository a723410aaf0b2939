// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/program/line_order.h"

#include <algorithm>

namespace proveout {

LineOrder::LineOrder(const LineOrder& other, const Extent& extent)
    : m_runs(other.m_runs), m_depth(extent.depth) {
    std::erase_if(m_runs, [&](const Run& run) { return run.number >= extent.runs; });
    if (extent.firstLine == 0)
        return;
    Run& run = m_runs[runAt(extent.firstLine)];
    run.lastLine = extent.lastLine;
    run.lastLineBlock = extent.lastLineBlock;
    run.end = kUnknown;
    m_open.push_back({extent.firstLine, 0});
}

LineOrder::Extent LineOrder::extent() const {
    if (m_open.empty() || m_open.front().depth > 0)
        return {.runs = m_runs.size(), .depth = m_depth};
    const Run& run = m_runs[runAt(m_open.front().firstLine)];
    return {m_runs.size(), m_depth, run.firstLine, run.lastLine, run.lastLineBlock};
}

void LineOrder::begin(std::uint32_t line, std::size_t depth, std::size_t blocks) {
    const bool returned = m_depth > depth;
    m_depth = depth;
    while (!m_open.empty() && m_open.back().depth > depth)
        endInnermost(blocks);
    if (!m_open.empty() && m_open.back().depth == depth) {
        const std::size_t index = runAt(m_open.back().firstLine);
        Run& run = m_runs[index];
        if (!returned && line == run.lastLine + 1 && !isIn(index + 1, line)) {
            run.lastLine = line;
            run.lastLineBlock = static_cast<std::uint32_t>(blocks);
            return;
        }
        endInnermost(blocks);
    }
    if (line > 0 && !isIn(runAt(line), line))
        add(line, depth, blocks);
}

LineOrder::Range LineOrder::beginOf(std::uint32_t line) const {
    const std::size_t index = runAt(line);
    if (index == m_runs.size())
        return {kUnknown, kUnknown};
    const Run& run = m_runs[index];
    if (line == run.lastLine)
        return {run.lastLineBlock, run.lastLineBlock};
    return {run.firstBlock, line > run.firstLine ? run.lastLineBlock : run.firstBlock};
}

LineOrder::Range LineOrder::endOf(std::uint32_t line) const {
    const std::size_t index = runAt(line);
    if (!isIn(index, line))
        return beginOf(line);
    const Run& run = m_runs[index];
    if (line == run.lastLine)
        return {run.end, run.end};
    return {run.firstBlock, run.lastLineBlock};
}

std::size_t LineOrder::runAt(std::uint32_t line) const {
    const auto at = std::ranges::lower_bound(m_runs, line, {}, &Run::lastLine);
    return static_cast<std::size_t>(at - m_runs.begin());
}

bool LineOrder::isIn(std::size_t run, std::uint32_t line) const {
    return run < m_runs.size() && m_runs[run].firstLine <= line && line <= m_runs[run].lastLine;
}

void LineOrder::endInnermost(std::size_t blocks) {
    m_runs[runAt(m_open.back().firstLine)].end = static_cast<std::uint32_t>(blocks);
    m_open.pop_back();
}

void LineOrder::add(std::uint32_t line, std::size_t depth, std::size_t blocks) {
    const auto count = static_cast<std::uint32_t>(blocks);
    const auto at = m_runs.begin() + static_cast<std::ptrdiff_t>(runAt(line));
    m_runs.insert(at, {line, line, count, count, kUnknown, static_cast<std::uint32_t>(m_runs.size())});
    m_open.push_back({line, depth});
}

} // namespace proveout
