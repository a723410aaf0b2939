// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/closer_look.h"

#include <exception>
#include <new>
#include <utility>

#include <QLocale>

#include "core/base/stop_watch.h"
#include "core/decimation/surface/refined_surface.h"
#include "core/verification/findings/window_findings.h"
#include "ui/look/diagnostic_text.h"

namespace proveout {
namespace {

/// During playback, or while a slider is dragged, only the block where it pauses is cut.
constexpr int kPause = 120; // ms
constexpr int kAtOnce = 0;
constexpr double kCutPart = 0.5;    ///< share of the whole work
constexpr double kWallPart = 0.7;   ///< where walls are found as well
constexpr double kLeastStep = 0.02; ///< smallest change of progress that is reported

/// Exceptions are caught here, because they must not leave the thread.
Result<FramePtr> closerOrRefused(const Frame& frame, const BoxOfInterest& box, const WorkContext& context) {
    try {
        return closerFrame(frame, box, context);
    } catch (const std::bad_alloc&) {
        return failure(window_finding::kDetailOutOfMemory);
    } catch (const std::exception& exception) {
        return failure(window_finding::kDetailFailed, {exception.what()});
    }
}

bool sameMoment(const Frame& a, const Frame& b) {
    return a.program == b.program && a.setup == b.setup && a.block == b.block;
}

} // namespace

Result<FramePtr> closerFrame(const Frame& frame, const BoxOfInterest& box, const WorkContext& context,
                             double availableBytes) {
    const DecimationParameters parameters = fineParameters(box.spacing);
    const auto part = fineGrid(*frame.setup, box, parameters,
                               {.schedule = false, .whole = true, .walls = true}, availableBytes);
    if (!part)
        return tl::unexpected(part.error());
    auto fine = cutBox(*frame.program, *frame.setup, frame.block, *part, context.part(0, kCutPart));
    if (!fine || !addWalls(*fine, frame.program, frame.setup, context.part(kCutPart, kWallPart)))
        return FramePtr();
    auto picture = std::make_shared<Frame>();
    picture->block = frame.block;
    picture->program = frame.program;
    picture->setup = frame.setup;
    picture->parameters = parameters;
    picture->zmap = fine->zmap;
    picture->surface = decimatedWhole(fine->zmap, parameters, context.part(kWallPart, 1));
    picture->level = parameters.level;
    if (context.stopped())
        return FramePtr();
    return picture;
}

CloserLook::CloserLook(QObject* parent) : QObject(parent) {
    m_pause.setSingleShot(true);
    connect(&m_pause, &QTimer::timeout, this, &CloserLook::cut);
}

bool CloserLook::isCurrent() const {
    return m_box && m_fine != nullptr && m_frame != nullptr && sameMoment(*m_fine, *m_frame);
}

void CloserLook::look(const BoxOfInterest& box) {
    if (m_box == box)
        return;
    m_box = box;
    m_fine.reset();
    cutSoon(kAtOnce);
}

void CloserLook::close() {
    m_box.reset();
    m_fine.reset();
    m_refused.clear();
    cancel();
}

void CloserLook::cancel() {
    m_task.cancel();
    m_pause.stop();
    m_working = false;
    emit changed();
}

void CloserLook::again() {
    if (isLeft())
        cutSoon(kAtOnce);
}

void CloserLook::follow(const FramePtr& frame) {
    const bool other = m_frame == nullptr || frame == nullptr || !sameMoment(*m_frame, *frame);
    m_frame = frame;
    if (m_box && other)
        cutSoon(kPause);
}

void CloserLook::cutSoon(int milliseconds) {
    m_task.cancel();
    m_refused.clear();
    m_working =
        m_frame != nullptr && m_frame->program != nullptr && m_frame->setup != nullptr && !isCurrent();
    m_done = 0;
    if (m_working)
        m_pause.start(milliseconds);
    else
        m_pause.stop();
    emit changed();
}

void CloserLook::cut() {
    m_task.start([this, frame = m_frame, box = *m_box](const NewestTask::Reply& reply) {
        WorkContext context{reply.stop, {}};
        context.progress = [&, reported = 0.0](double done) mutable {
            if (done < reported + kLeastStep)
                return;
            reported = done;
            reply.post([this, done] {
                m_done = done;
                emit changed();
            });
        };
        const StopWatch watch;
        auto result = closerOrRefused(*frame, box, context);
        reply.post([this, result = std::move(result), took = watch.seconds()] { finished(result, took); });
    });
}

void CloserLook::finished(const Result<FramePtr>& result, double seconds) {
    m_working = false;
    m_seconds = seconds;
    m_fine = result ? *result : nullptr;
    if (!result)
        m_refused = result.error();
    emit changed();
}

QString CloserLook::status() const {
    if (!m_box)
        return tr("Drag a box on the stock, or click a point.");
    if (!m_refused.empty())
        return sentence(m_refused.front());
    if (m_frame == nullptr)
        return {};
    const QLocale locale;
    const QString block = locale.toString(static_cast<qulonglong>(m_frame->block));
    if (m_working)
        return tr("At block %1: cutting…").arg(block);
    if (!isCurrent())
        return tr("At block %1: cancelled.").arg(block);
    const Grid& grid = m_fine->zmap.grid();
    return tr("At block %1: %2 × %3 points, spacing %4 mm; %5 triangles, %6 s")
        .arg(block, locale.toString(grid.nx), locale.toString(grid.ny), locale.toString(grid.hx, 'g', 4),
             locale.toString(static_cast<qulonglong>(m_fine->surface.faces)),
             locale.toString(m_seconds, 'f', 2));
}

} // namespace proveout
