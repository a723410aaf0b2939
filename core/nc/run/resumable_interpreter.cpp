// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/run/resumable_interpreter.h"

#include <algorithm>
#include <utility>

#include "core/nc/flow/flow_index.h"
#include "core/nc/flow/macro_index.h"
#include "core/nc/run/foreign_text.h"
#include "core/nc/run/interpretation.h"

namespace proveout {

namespace {

/// The lines [first, last) of a text.
NcText part(const NcText& text, std::size_t first, std::size_t last) {
    std::string lines;
    for (std::size_t i = first; i < last; ++i)
        lines.append(text.line(i)).append(1, '\n');
    return NcText(std::move(lines));
}

bool hasTargets(const NcText& text) {
    return !FlowIndex(text).empty() || !MacroIndex(text).empty();
}

/// Whether the lines from `first` on in which two texts differ contain a possible target of a call or a jump.
bool targetsChanged(const NcText& a, const NcText& b, std::size_t first) {
    const std::size_t most = std::min(a.lineCount(), b.lineCount()) - first;
    std::size_t same = 0;
    while (same < most && a.line(a.lineCount() - 1 - same) == b.line(b.lineCount() - 1 - same))
        ++same;
    return hasTargets(part(a, first, a.lineCount() - same)) ||
           hasTargets(part(b, first, b.lineCount() - same));
}

bool alike(const InterpretOptions& a, InterpretOptions b) {
    b.stopAfterBlocks = a.stopAfterBlocks;
    b.watchedLine = a.watchedLine;
    b.watchToEnd = a.watchToEnd;
    return a == b;
}

bool sameText(const NcText& a, const NcText& b) {
    return a.size() == b.size() && a.lineCount() == b.lineCount() && a.sameLines(b) + 1 >= a.lineCount();
}

} // namespace

std::shared_ptr<const Program> ResumableInterpreter::interpret(const NcText& text,
                                                               const InterpretOptions& options,
                                                               const WorkContext& context,
                                                               const PublishBeginning& publish) {
    if (auto foreign = foreignProgram(text, options)) {
        m_last.reset();
        forgetFrom(0);
        m_resumedAt = 0;
        return foreign;
    }
    Run now{text, options, options.dialect ? DialectGuess{*options.dialect, {}} : guessDialect(text), {}};
    Interpretation run(now.text, now.options, now.guess, context);
    const bool again = m_last && alike(m_last->options, options) && m_last->guess == now.guess;
    const std::size_t unchanged = again ? unchangedPoints(text) : 0;
    const std::size_t usable = pointsBefore(options, unchanged);
    m_resumedAt = 0;
    if (usable > 0) {
        m_resumedAt = m_points[usable - 1].calls.line;
        run.resume(m_points[usable - 1], *m_last->program);
    }
    // Points after this place are kept when only the same text is examined again.
    if (again && usable < unchanged && sameText(text, m_last->text))
        return run.run();

    // In case of an exception: points without the program that they belong to are useless.
    m_last.reset();
    forgetFrom(usable);
    if (usable == 0)
        m_distance = m_leastDistance;
    Beginnings beginnings(publish, now.options.file);
    run.publish(beginnings);
    run.keepPoints(m_resumedAt + m_distance, [&](ResumePoint point) { return keep(std::move(point)); });
    now.program = run.run();
    // An endless loop discards what it has made.
    std::erase_if(m_points, [&](const ResumePoint& point) {
        return point.program.motions > now.program->motionCount() ||
               point.program.events > now.program->events().size();
    });
    m_last = std::move(now);
    return m_last->program;
}

std::size_t ResumableInterpreter::pointsBefore(const InterpretOptions& options, std::size_t most) const {
    const auto end = m_points.begin() + static_cast<std::ptrdiff_t>(most);
    const auto at = std::partition_point(m_points.begin(), end, [&](const ResumePoint& p) {
        return p.program.blocks < options.stopAfterBlocks &&
               (options.watchedLine == 0 || p.run.read.linesRead < options.watchedLine);
    });
    return static_cast<std::size_t>(at - m_points.begin());
}

void ResumableInterpreter::forgetFrom(std::size_t index) {
    m_points.erase(m_points.begin() + static_cast<std::ptrdiff_t>(index), m_points.end());
}

std::size_t ResumableInterpreter::keep(ResumePoint point) {
    const std::size_t line = point.calls.line;
    m_points.push_back(std::move(point));
    if (m_points.size() == kMostPoints) {
        // Every second one is kept.
        for (std::size_t i = 0; i < kMostPoints / 2; ++i)
            m_points[i] = std::move(m_points[2 * i + 1]);
        forgetFrom(kMostPoints / 2);
        m_distance *= 2;
    }
    return line + m_distance;
}

std::size_t ResumableInterpreter::unchangedPoints(const NcText& text) const {
    const NcText& before = m_last->text;
    const std::size_t same = text.sameLines(before);
    auto end = std::ranges::upper_bound(m_points, same, {},
                                        [](const ResumePoint& p) { return p.run.read.linesSeen; });
    if (end != m_points.begin() && std::prev(end)->calls.indexAsked && targetsChanged(before, text, same))
        end = std::ranges::find_if(m_points.begin(), end,
                                   [](const ResumePoint& p) { return p.calls.indexAsked; });
    return static_cast<std::size_t>(end - m_points.begin());
}

} // namespace proveout
