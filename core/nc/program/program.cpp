// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/program/program.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

namespace proveout {

namespace {

constexpr std::uint32_t kNoArc = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint8_t kUnverifiedFlag = 1;
constexpr std::uint8_t kPerRevolutionFlag = 2;
constexpr std::uint8_t kStartAtReferenceFlag = 4;
constexpr std::uint8_t kEndAtReferenceFlag = 8;
constexpr std::uint8_t kProbingFlag = 16;
/// Those on which the stock or a finding may depend.
constexpr std::uint8_t kPathFlags = kStartAtReferenceFlag | kEndAtReferenceFlag | kProbingFlag;

} // namespace

Program::Extent Program::extent() const {
    return {m_motions.size(),       m_arcs.size(),   m_states.size(),      m_blocks.size(), m_jumps.size(),
            m_compensations.size(), m_events.size(), m_diagnostics.size(), m_bounds,        m_cuttingBounds,
            m_pendingLine,          m_blockPending,  m_lines.extent(),     m_settled};
}

Program::Program(const Program& other, const Extent& extent)
    : m_settled(extent.motions), m_bounds(extent.bounds), m_cuttingBounds(extent.cuttingBounds),
      m_pendingLine(extent.pendingLine), m_blockPending(extent.blockPending),
      m_lines(other.m_lines, extent.lines, extent.blocks), m_dialect(other.m_dialect) {
    // Reserves memory for about as much again as the other one has after it.
    m_motions.reserve(other.m_motions.size());
    m_blocks.reserve(other.m_blocks.size());
    m_arcs.reserve(other.m_arcs.size());
    const auto copyFirst = [](auto& to, const auto& from, std::size_t count) {
        to.assign(from.begin(), from.begin() + static_cast<std::ptrdiff_t>(count));
    };
    copyFirst(m_motions, other.m_motions, extent.motions);
    copyFirst(m_arcs, other.m_arcs, extent.arcs);
    copyFirst(m_states, other.m_states, extent.states);
    copyFirst(m_blocks, other.m_blocks, extent.blocks);
    copyFirst(m_jumps, other.m_jumps, extent.jumps);
    copyFirst(m_compensations, other.m_compensations, extent.compensations);
    copyFirst(m_events, other.m_events, extent.events);
    copyFirst(m_diagnostics, other.m_diagnostics, extent.diagnostics);
    copyFirst(m_diagnosticMotions, other.m_diagnosticMotions, extent.diagnostics);
    m_unverified = std::ranges::any_of(m_diagnostics, &Diagnostic::unverified);
}

Motion Program::motion(std::size_t index) const {
    const PackedMotion& packed = m_motions[index];
    Motion motion;
    motion.kind = static_cast<MotionKind>(packed.kind);
    motion.startKnown = packed.startKnown;
    motion.endKnown = packed.endKnown;
    motion.unverified = (packed.flags & kUnverifiedFlag) != 0;
    motion.perRevolution = (packed.flags & kPerRevolutionFlag) != 0;
    motion.startAtReference = (packed.flags & kStartAtReferenceFlag) != 0;
    motion.endAtReference = (packed.flags & kEndAtReferenceFlag) != 0;
    motion.probing = (packed.flags & kProbingFlag) != 0;
    motion.tool = m_states[packed.state].tool;
    motion.spindleRpm = m_states[packed.state].spindleRpm;
    motion.orderedRpm = m_states[packed.state].orderedRpm;
    motion.line = packed.line;
    motion.start = startOf(index);
    motion.end = packed.end;
    motion.feedMmPerMin = static_cast<double>(packed.feedMmPerMin);
    if (packed.arc != kNoArc) {
        const PackedArc& arc = m_arcs[packed.arc];
        motion.plane = arc.plane;
        motion.centre = arc.centre;
        motion.sweep = arc.sweep;
    }
    return motion;
}

Vec3 Program::programmedEnd(std::size_t index) const {
    const auto compensation = std::ranges::lower_bound(m_compensations, index, {}, &Compensation::motion);
    const bool compensated = compensation != m_compensations.end() && compensation->motion == index;
    return compensated ? m_motions[index].end - Vec3(compensation->offset) : m_motions[index].end;
}

Vec3 Program::startOf(std::size_t index) const {
    if (!m_jumps.empty()) {
        const auto jump = std::lower_bound(m_jumps.begin(), m_jumps.end(), index,
                                           [](const Jump& j, std::size_t i) { return j.motion < i; });
        if (jump != m_jumps.end() && jump->motion == index)
            return jump->start;
    }
    return index == 0 ? Vec3(0) : m_motions[index - 1].end;
}

Program::MotionRange Program::blockMotions(std::size_t index) const {
    const std::size_t last = index + 1 < m_blocks.size() ? m_blocks[index + 1].firstMotion : m_motions.size();
    return {m_blocks[index].firstMotion, last};
}

std::uint32_t Program::blockLine(std::size_t index) const {
    return m_blocks[index].line;
}

std::vector<Program::ToolRun> Program::toolRuns() const {
    std::vector<ToolRun> runs;
    auto first = m_motions.begin();
    while (first != m_motions.end()) {
        const auto same = [&](const PackedMotion& motion) { return motion.state == first->state; };
        // Runs may be short and many: the steps double, until one leads out of the run.
        std::ptrdiff_t step = 1;
        while (step < m_motions.end() - first && same(first[step]))
            step *= 2;
        const auto last = std::partition_point(first, first + std::min(step, m_motions.end() - first), same);
        const auto end = static_cast<std::size_t>(last - m_motions.begin());
        const int tool = m_states[first->state].tool;
        if (!runs.empty() && runs.back().tool == tool)
            runs.back().last = end;
        else
            runs.push_back({tool, static_cast<std::size_t>(first - m_motions.begin()), end});
        first = last;
    }
    return runs;
}

std::size_t Program::blocksBeforeLine(std::uint32_t line) const {
    return firstBlockFrom(line, m_lines.beginOf(line));
}

std::size_t Program::blocksAfterLine(std::uint32_t line) const {
    return firstBlockFrom(line + 1, m_lines.endOf(line));
}

std::size_t Program::firstBlockFrom(std::uint32_t line, const LineOrder::Range& among) const {
    const auto to = [&](std::size_t block) { return m_blocks.data() + std::min(block, blockCount()); };
    const auto* at = std::ranges::lower_bound(to(among.first), to(among.last), line, {}, &PackedBlock::line);
    return static_cast<std::size_t>(at - m_blocks.data());
}

std::size_t Program::firstDifference(const Program& other) const {
    const std::size_t common = std::min(blockCount(), other.blockCount());
    for (std::size_t i = 0; i < common; ++i) {
        if (!sameBlock(i, other))
            return i;
    }
    return common;
}

bool Program::sameBlock(std::size_t index, const Program& other) const {
    const MotionRange mine = blockMotions(index);
    const MotionRange theirs = other.blockMotions(index);
    if (mine.last - mine.first != theirs.last - theirs.first)
        return false;
    for (std::size_t i = 0; i < mine.last - mine.first; ++i) {
        if (!samePath(mine.first + i, other, theirs.first + i))
            return false;
    }
    return true;
}

bool Program::samePath(std::size_t index, const Program& other, std::size_t otherIndex) const {
    const PackedMotion& a = m_motions[index];
    const PackedMotion& b = other.m_motions[otherIndex];
    if (a.end != b.end || a.kind != b.kind || a.startKnown != b.startKnown || a.endKnown != b.endKnown ||
        (a.flags & kPathFlags) != (b.flags & kPathFlags) ||
        m_states[a.state].tool != other.m_states[b.state].tool || startOf(index) != other.startOf(otherIndex))
        return false;
    if (a.arc == kNoArc || b.arc == kNoArc)
        return a.arc == b.arc;
    const PackedArc& arcA = m_arcs[a.arc];
    const PackedArc& arcB = other.m_arcs[b.arc];
    return arcA.centre == arcB.centre && arcA.sweep == arcB.sweep && arcA.plane == arcB.plane;
}

void Program::expect(std::size_t blocks) {
    constexpr std::size_t kMost = 4'000'000;
    m_motions.reserve(std::min(blocks, kMost));
    m_blocks.reserve(std::min(blocks, kMost));
}

void Program::beginBlock(std::uint32_t line) {
    m_pendingLine = line;
    m_blockPending = true;
}

void Program::append(const Motion& motion) {
    settle();
    store(motion);
    addToBounds(motion);
    m_settled = m_motions.size();
}

void Program::appendCompensated(const Motion& motion, const Vec3& programmedEnd) {
    m_compensations.push_back(
        {static_cast<std::uint32_t>(m_motions.size()), glm::vec3(motion.end - programmedEnd)});
    static_assert(sizeof(Compensation) == kBytesPerCompensation);
    store(motion);
}

void Program::moveEnds(std::size_t first, Plane plane, const Vec2& end, double sweep) {
    assert(first >= m_settled);
    const PlaneAxes axes = proveout::axes(plane);
    auto compensation = std::ranges::lower_bound(m_compensations, first, {}, &Compensation::motion);
    for (std::size_t i = first; i < m_motions.size(); ++i, ++compensation) {
        const Vec3 before = m_motions[i].end;
        m_motions[i].end[axes.first] = end.x;
        m_motions[i].end[axes.second] = end.y;
        compensation->offset += glm::vec3(m_motions[i].end - before);
    }
    if (m_motions[first].arc != kNoArc)
        m_arcs[m_motions[first].arc].sweep = sweep;
}

void Program::settle() {
    for (; m_settled < m_motions.size(); ++m_settled)
        addToBounds(motion(m_settled));
}

void Program::cutBack(const Extent& extent) {
    const auto keep = [](auto& all, std::size_t count) {
        all.resize(count);
        all.shrink_to_fit();
    };
    keep(m_motions, extent.motions);
    keep(m_arcs, extent.arcs);
    keep(m_states, extent.states);
    keep(m_blocks, extent.blocks);
    keep(m_jumps, extent.jumps);
    keep(m_compensations, extent.compensations);
    keep(m_events, extent.events);
    for (std::uint32_t& motion : m_diagnosticMotions)
        motion = std::min(motion, static_cast<std::uint32_t>(extent.motions));
    m_bounds = extent.bounds;
    m_cuttingBounds = extent.cuttingBounds;
    m_pendingLine = extent.pendingLine;
    m_blockPending = extent.blockPending;
    m_settled = extent.settled;
    settle();
}

std::size_t Program::bytes() const {
    const auto of = [](const auto& all) { return all.size() * sizeof(all.front()); };
    return of(m_motions) + of(m_arcs) + of(m_states) + of(m_blocks) + of(m_jumps) + of(m_compensations) +
           of(m_events) + m_lines.bytes();
}

void Program::addToBounds(const Motion& motion) {
    if (!motion.known())
        return;
    const Box3 box = proveout::bounds(motion);
    m_bounds.add(box);
    if (motion.kind != MotionKind::rapid && !motion.probing)
        m_cuttingBounds.add(box);
}

void Program::store(const Motion& motion) {
    const auto index = static_cast<std::uint32_t>(m_motions.size());
    if (m_blockPending) {
        m_blocks.push_back({index, m_pendingLine});
        m_blockPending = false;
    }
    const SpindleState state{motion.tool, motion.spindleRpm, motion.orderedRpm};
    if (m_states.empty() || m_states.back() != state)
        m_states.push_back(state);
    if (motion.start != (m_motions.empty() ? Vec3(0) : m_motions.back().end))
        m_jumps.push_back({index, motion.start});

    PackedMotion packed{};
    packed.end = motion.end;
    packed.feedMmPerMin = static_cast<float>(motion.feedMmPerMin);
    packed.line = motion.line;
    packed.arc = kNoArc;
    packed.state = static_cast<std::uint32_t>(m_states.size() - 1);
    packed.kind = static_cast<std::uint8_t>(motion.kind);
    packed.startKnown = motion.startKnown;
    packed.endKnown = motion.endKnown;
    packed.flags = static_cast<std::uint8_t>(
        (motion.unverified ? kUnverifiedFlag : 0) | (motion.perRevolution ? kPerRevolutionFlag : 0) |
        (motion.startAtReference ? kStartAtReferenceFlag : 0) |
        (motion.endAtReference ? kEndAtReferenceFlag : 0) | (motion.probing ? kProbingFlag : 0));
    if (motion.kind == MotionKind::arc) {
        packed.arc = static_cast<std::uint32_t>(m_arcs.size());
        m_arcs.push_back({motion.centre, motion.sweep, motion.plane});
    }
    static_assert(sizeof(PackedMotion) == kBytesPerMotion);
    m_motions.push_back(packed);
}

void Program::delayEvents(std::size_t first) {
    for (std::size_t i = first; i < m_events.size(); ++i)
        m_events[i].beforeMotion = static_cast<std::uint32_t>(m_motions.size());
}

void Program::append(EventData data, std::uint32_t line) {
    m_events.push_back({static_cast<std::uint32_t>(m_motions.size()), line, data});
}

void Program::append(Diagnostic diagnostic) {
    m_unverified = m_unverified || diagnostic.unverified;
    m_diagnosticMotions.push_back(static_cast<std::uint32_t>(m_motions.size()));
    m_diagnostics.push_back(std::move(diagnostic));
}

} // namespace proveout
