// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/program/block_search.h"

#include <exception>
#include <utility>

#include "core/simulation/setup/tool_choice.h"
#include "core/verification/findings/window_findings.h"

namespace proveout {
namespace {

constexpr int kPatience = 200;      // ms; faster searches show no progress
constexpr double kLeastStep = 0.02; // smallest change of progress that is reported

PlaceAnswer answerOf(const Frame& moment, const std::optional<std::size_t>& block) {
    if (!block)
        return {PlaceAnswer::Kind::neverCut, moment.block};
    const Program& program = *moment.program;
    const int number = program.motion(program.blockMotions(*block).first).tool;
    const ToolChoice choice(program, *moment.setup);
    return {PlaceAnswer::Kind::cut, *block + 1, program.blockLine(*block), choice.tool(number),
            choice.isAssumed(number)};
}

} // namespace

BlockSearch::BlockSearch(QObject* parent, Find find) : QObject(parent), m_find(std::move(find)) {
    if (!m_find)
        m_find = [](const Frame& moment, const MapPoint& point, const WorkContext& context) {
            return blockThatMade(moment, point, context);
        };
    m_patience.setSingleShot(true);
    m_patience.setInterval(kPatience);
    connect(&m_patience, &QTimer::timeout, this, [this] {
        m_done = 0;
        emit progressed();
    });
}

void BlockSearch::ask(const FramePtr& moment, const MapPoint& point) {
    cancel();
    m_patience.start();
    m_task.start([this, moment, point](const Reply& reply) { carryOut(moment, point, reply); });
}

void BlockSearch::cancel() {
    m_task.cancel();
    finish();
}

void BlockSearch::finish() {
    m_patience.stop();
    if (std::exchange(m_done, std::nullopt))
        emit progressed();
}

/// Runs on the task's thread; exceptions are caught here.
void BlockSearch::carryOut(const FramePtr& moment, const MapPoint& point, const Reply& reply) {
    WorkContext context{reply.stop, {}};
    context.progress = [&, reported = 0.0](double done) mutable {
        if (done < reported + kLeastStep)
            return;
        reported = done;
        reply.post([this, done] {
            if (!m_done)
                return;
            m_done = done;
            emit progressed();
        });
    };
    try {
        const PlaceAnswer answer = answerOf(*moment, m_find(*moment, point, context));
        reply.post([this, answer] {
            finish();
            emit answered(answer);
        });
    } catch (const std::exception& exception) {
        auto errors = failure(window_finding::kBlockSearchFailed, {exception.what()}).value();
        reply.post([this, errors = std::move(errors)] {
            finish();
            emit failed(errors);
        });
    }
}

} // namespace proveout
