// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/window/fault_visit.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>

#include <QApplication>
#include <QElapsedTimer>
#include <QMessageBox>
#include <QTimer>

#include "core/base/memory.h"
#include "tests/ui/window/heartbeat.h"
#include "ui/document/file_paths.h"

namespace proveout {

namespace {

constexpr qint64 kRestMs = 300;
constexpr int kLongestMs = 300'000;

/// Writing 5 there makes Linux reset the peak.
void resetPeak() {
    std::ofstream("/proc/self/clear_refs") << 5;
}

/// Closes dialogs, which would block everything, and keeps their texts.
class DialogCloser {
public:
    DialogCloser() {
        QObject::connect(&m_look, &QTimer::timeout, [this] {
            QWidget* dialog = QApplication::activeModalWidget();
            if (dialog == nullptr)
                return;
            const auto* box = qobject_cast<QMessageBox*>(dialog);
            m_text = (box != nullptr ? box->text() : dialog->windowTitle()).toStdString();
            dialog->close();
        });
        m_look.start(50);
    }
    [[nodiscard]] const std::string& text() const { return m_text; }

private:
    QTimer m_look;
    std::string m_text;
};

/// Whether the file is either refused or shown, and no work is in progress.
class Opening {
public:
    explicit Opening(Session& session) : m_session(session) {
        QObject::connect(&session.document(), &DocumentHub::opened, &m_context, [this] { m_opened = true; });
        QObject::connect(&session.problems(), &ProblemsHub::troubled, &m_context,
                         [this] { m_troubled = true; });
    }
    [[nodiscard]] bool isOver() const {
        if (m_session.document().isOpening() || m_session.work().current())
            return false;
        if (!m_opened)
            return m_troubled;
        return m_session.program().current() && !m_session.program().isReading() &&
               (m_session.simulation().frame() || m_session.program().isForeign() || m_troubled);
    }

private:
    Session& m_session;
    QObject m_context;
    bool m_opened = false;
    bool m_troubled = false;
};

/// Waits until `done` has been true for a while; returns the seconds until then, negative if never.
double secondsUntil(const std::function<bool()>& done) {
    QElapsedTimer clock;
    clock.start();
    qint64 since = -1;
    const auto rests = [&] {
        if (!done())
            since = -1;
        else if (since < 0)
            since = clock.elapsed();
        return since >= 0 && clock.elapsed() - since >= kRestMs;
    };
    return QTest::qWaitFor(rests, kLongestMs) ? 1e-3 * static_cast<double>(since) : -1;
}

bool goesTo(Session& session, std::size_t block) {
    if (!session.simulation().frame())
        return true;
    session.playback().seek(block);
    return secondsUntil([&] {
               return !session.work().current() &&
                      (!session.simulation().frame() || session.simulation().block() == block);
           }) >= 0;
}

/// Returns whether the session has noticed.
bool disturb(const Session& session, const FaultCase& fault) {
    if (fault.whileOpen == WhileOpen::nothing)
        return true;
    QObject context;
    bool noticed = false;
    QObject::connect(&session.document(), &DocumentHub::fileChangedOnDisk, &context,
                     [&noticed] { noticed = true; });
    if (fault.whileOpen == WhileOpen::removed)
        std::filesystem::remove(fault.file);
    else if (fault.whileOpen == WhileOpen::shrunk)
        std::filesystem::resize_file(fault.file, 5);
    else
        std::ofstream(fault.file, std::ios::app) << "G0 X1\n";
    return QTest::qWaitFor([&noticed] { return noticed; }, kPatience);
}

/// A program without a tool cuts nothing, so this adds one, like the button for missing tools.
void giveTool(Session& session) {
    if (!session.document().jobFile().isEmpty() || !session.simulation().frame())
        return;
    Setup setup = session.job().setup();
    setup.tools.set(1, parseCutter("flat:d=4,l=20").value());
    if (!session.job().setup().startTool)
        setup.startTool = 1;
    if (!session.job().setSetup(setup))
        return; // the stock is too large
    const auto isCut = [&] {
        return session.simulation().frame() &&
               session.simulation().frame()->program == session.program().current() &&
               session.simulation().frame()->setup->tools == session.job().setup().tools;
    };
    static_cast<void>(secondsUntil(
        [&] { return !session.work().current() && (isCut() || session.program().isForeign()); }));
}

/// Returns to the sample without the window's question, whatever has happened to the case's file.
void goBack(Session& session) {
    const Opening opening(session);
    session.document().openFile(sampleJobs().front().file);
    if (secondsUntil([&] { return opening.isOver(); }) < 0)
        qFatal("the sample does not come back");
}

std::vector<std::string> messagesOf(const Session& session) {
    std::vector<std::string> messages;
    for (Diagnostic problem : session.problems().all()) {
        if (ProblemsHub::isInText(problem))
            problem.file = session.document().text().path.filename().string();
        messages.push_back(oneLine(problem));
    }
    return messages;
}

} // namespace

FaultVisit visitFault(Workstation& station, const FaultCase& fault) {
    Session& session = station.session;
    FaultVisit visit;
    resetPeak();
    visit.startBytes = static_cast<double>(peakMemoryBytes());
    {
        const DialogCloser closer;
        const Opening opening(session);
        Heartbeat heart;
        session.document().openFile(toQString(fault.file));
        visit.seconds = secondsUntil([&] { return opening.isOver(); });
        visit.messages = messagesOf(session);
        visit.blocks = session.program().blockCount();
        giveTool(session);
        visit.settled = visit.seconds >= 0 && goesTo(session, session.program().blockCount());
        visit.cutMessages = messagesOf(session);
        visit.noticed = disturb(session, fault);
        visit.settled = goesTo(session, 0) && visit.settled;
        heart.stop();
        visit.longestMs = std::ranges::max(heart.gaps());
        visit.computedMs = std::ranges::max(heart.computed());
        visit.dialog = closer.text();
    }
    visit.peakBytes = static_cast<double>(peakMemoryBytes());
    goBack(session);
    return visit;
}

} // namespace proveout
