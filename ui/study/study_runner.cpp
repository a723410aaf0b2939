// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/study/study_runner.h"

#include <algorithm>
#include <exception>
#include <new>
#include <utility>

#include <QThread>

#include "core/verification/findings/window_findings.h"

namespace proveout {

namespace {
constexpr std::size_t kFramesARun = 64; ///< number of drawn frames, limited so that drawing does not take
                                        ///< most of a sweep
constexpr int kCheckingRuns = 3;
constexpr double kRehearsed = 0.2; ///< share of the progress that the choice takes

using Work = std::function<Result<void>(DrawCost&, const WorkContext&)>;

/// Unexpected exceptions are reported too, and end only the study.
Result<void> carriedOut(const Work& work, DrawCost& drawing, const WorkContext& context) {
    try {
        return work(drawing, context);
    } catch (const std::bad_alloc&) {
        return failure(window_finding::kStudyOutOfMemory);
    } catch (const std::exception& exception) {
        return failure(window_finding::kStudyFailed, {exception.what()});
    }
}

} // namespace

StudyRunner::StudyRunner(MakeDrawing makeDrawing, QObject* parent)
    : QObject(parent), m_makeDrawing(std::move(makeDrawing)) {}

StudyRunner::~StudyRunner() {
    cancel();
    if (m_thread != nullptr) {
        m_thread->wait();
        delete m_thread;
    }
}

SweepOptions StudyRunner::options(DrawCost& drawing, const StudyJob& job, int repeats) const {
    return {&drawing, std::max<std::size_t>(1, job.program->blockCount() / kFramesARun), repeats, {}};
}

void StudyRunner::sweep(StudyJob job, std::vector<StudyPoint> points) {
    start([this, job = std::move(job),
           points = std::move(points)](DrawCost& drawing, const WorkContext& context) -> Result<void> {
        SweepOptions sweeping = options(drawing, job, 1);
        sweeping.finished = [this](const StudyRun& run) {
            m_replies.post([this, shared = std::make_shared<const StudyRun>(run)] { emit ran(shared); });
        };
        const auto swept = runSweep(job, points, sweeping, context);
        return swept ? Result<void>() : tl::unexpected(swept.error());
    });
}

void StudyRunner::optimise(StudyJob job, const DecimationParameters& given) {
    start([this, job = std::move(job), given](DrawCost& drawing, const WorkContext& context) -> Result<void> {
        auto found = rehearse(job, given, rehearsalFor(job), drawing,
                              {context.stop, [&](double done) { context.report(kRehearsed * done); }});
        if (!found)
            return tl::unexpected(std::move(found.error()));
        const auto rehearsal = std::make_shared<const Rehearsal>(std::move(*found));
        m_replies.post([this, rehearsal] { emit rehearsed(rehearsal); });
        const std::vector<StudyPoint> points{{withSchedule(given, cheapest(*rehearsal))}, {given}};
        const auto swept = runSweep(
            job, points, options(drawing, job, kCheckingRuns),
            {context.stop, [&](double done) { context.report(kRehearsed + (1 - kRehearsed) * done); }});
        if (!swept)
            return tl::unexpected(swept.error());
        m_replies.post(
            [this, chosen = (*swept)[0].seconds, as = (*swept)[1].seconds] { emit measured(chosen, as); });
        return {};
    });
}

void StudyRunner::start(std::function<Result<void>(DrawCost&, const WorkContext&)> work) {
    if (busy())
        return;
    m_stop = std::stop_source();
    m_thread = QThread::create([this, work = std::move(work)] {
        int reported = 0;
        const WorkContext context{m_stop.get_token(), [&](double done) {
                                      if (const int percent = static_cast<int>(100 * done);
                                          percent > reported) {
                                          reported = percent;
                                          m_replies.post([this, done] { emit progressed(done); });
                                      }
                                  }};
        const Result<void> done = carriedOut(work, *m_drawing, context);
        m_drawing->end();
        if (!done && !context.stopped())
            m_replies.post([this, problems = done.error()] { emit failed(problems); });
    });
    auto drawing = m_makeDrawing(m_thread);
    if (!drawing) {
        delete std::exchange(m_thread, nullptr);
        emit failed(drawing.error());
        emit ended();
        return;
    }
    m_drawing = std::move(*drawing);
    connect(m_thread, &QThread::finished, this, [this] {
        m_thread->wait();
        delete std::exchange(m_thread, nullptr);
        m_drawing.reset();
        emit ended();
    });
    m_thread->start(QThread::LowPriority); // the window has priority
}

} // namespace proveout
