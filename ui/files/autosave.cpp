// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/files/autosave.h"

#include <algorithm>
#include <exception>
#include <iterator>
#include <utility>

#include "core/base/stop_watch.h"
#include "core/verification/findings/window_findings.h"
#include "ui/files/kept_breakpoints.h"

namespace proveout {

namespace {

Result<void> keepOrReport(const QString& folder, const JobDocument& document, const SessionState& state) {
    try {
        return keepSession(folder, document, state);
    } catch (const std::exception& problem) {
        return failure(window_finding::kBackupFailed, {problem.what()});
    }
}

} // namespace

Autosave::Autosave(Session& session, const QString& root, std::function<QByteArray()> layout)
    : m_session(session), m_layout(std::move(layout)) {
    if (Result<SessionFolder> folder = SessionFolder::create(root))
        m_folder = std::move(*folder);
    connect(&session.document(), &DocumentHub::changed, this, [this] { m_otherDocument = true; });
    connect(&session.document(), &DocumentHub::textReplaced, this, [this] { rest(0); });
    connect(&m_timer, &QTimer::timeout, this, &Autosave::look);
    m_timer.start(kIntervalMs);
}

SessionState Autosave::state() const {
    return {KeptBreakpoints::written(m_session.breakpoints().all()), m_layout()};
}

void Autosave::look() {
    if (m_writing)
        return;
    m_session.job().collectChanges();
    if (m_otherDocument || m_keptRevision != m_session.document().job().revision() ||
        !(m_keptState == state()))
        keepNow([] {});
}

void Autosave::keepNow(std::function<void()> done) {
    if (!m_folder)
        return;
    m_waiting.push_back(std::move(done));
    if (!m_writing)
        write();
}

void Autosave::write() {
    m_writing = true;
    m_otherDocument = false;
    m_keptRevision = m_session.document().job().revision();
    m_keptState = state();
    // The thread gets its own copies; the text is shared and immutable.
    m_task.start([this, folder = m_folder->path(), document = m_session.document().job(), state = m_keptState,
                  done = std::exchange(m_waiting, {})](const NewestTask::Reply& reply) mutable {
        const StopWatch watch;
        const Result<void> kept = keepOrReport(folder, document, state);
        reply.post([this, kept, done = std::move(done), seconds = watch.seconds()]() mutable {
            written(kept, seconds, std::move(done));
        });
    });
}

void Autosave::written(const Result<void>& kept, double seconds, std::vector<std::function<void()>> done) {
    m_writing = false;
    if (!m_otherDocument) // its text may be short
        rest(seconds);
    const bool asked = !m_waiting.empty(); // since that write began
    if (kept) {
        for (const auto& each : done)
            each();
    } else {
        if (!m_failed)
            m_session.problems().report(kept.error());
        m_otherDocument = true; // try again
        std::ranges::move(done, std::back_inserter(m_waiting));
    }
    m_failed = !kept;
    if (asked && m_folder)
        write();
}

void Autosave::rest(double seconds) {
    constexpr double kRestPerWork = 20;
    const int interval = std::max(kIntervalMs, static_cast<int>(kRestPerWork * seconds * 1000));
    if (m_timer.isActive() && interval != m_timer.interval())
        m_timer.setInterval(interval);
}

void Autosave::end() {
    m_timer.stop();
    if (!m_folder)
        return;
    // Runs after the write in progress.
    m_task.start([folder = std::make_shared<SessionFolder>(std::move(*m_folder))](const NewestTask::Reply&) {
        folder->remove();
    });
    m_folder.reset();
}

} // namespace proveout
