// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workstation/screenshot_run.h"

#include <algorithm>

#include <QCoreApplication>
#include <QDockWidget>
#include <QPixmap>

#include "app/cli/run_command.h"
#include "core/verification/findings/command_line_findings.h"
#include "ui/viewport/viewport.h"

namespace proveout {

namespace {
constexpr int kSettleMs = 700;
constexpr int kLimitMs = 180'000;
constexpr int kFailed = 3;
constexpr int kSmallestFile = 0; ///< the "quality" of a PNG: 0 is the strongest compression
const QString kView = QStringLiteral("view");
const QString kPlots = QStringLiteral("plots");
} // namespace

ScreenshotRun::ScreenshotRun(MainWindow& window, const ScreenshotRequest& request)
    : QObject(&window), m_window(window), m_request(request),
      m_shown(request.panel.isEmpty() ? &window : shownAlone(request.panel, request.size)) {
    m_settle.setSingleShot(true);
    m_settle.setInterval(kSettleMs);
    m_limit.setSingleShot(true);
    connect(&m_settle, &QTimer::timeout, this, &ScreenshotRun::take);
    connect(&m_limit, &QTimer::timeout, this, &ScreenshotRun::reachLimit);
    connect(&window.session().playback(), &PlaybackHub::tick, this, &ScreenshotRun::look);
    if (m_shown.isNull()) {
        QTimer::singleShot(0, this, [this] { giveUp("there is no such panel"); });
        return;
    }
    m_limit.start(kLimitMs);
    if (!window.session().document().isOpen())
        m_settle.start(); // the start page
}

/// Shows a panel in a separate window, because only that can have any size; null if there is no such panel.
QWidget* ScreenshotRun::shownAlone(const QString& panel, QSize size) {
    if (panel == kView) {
        for (QDockWidget* dock : m_window.findChildren<QDockWidget*>())
            dock->hide();
        return &m_window.viewport();
    }
    auto* dock = m_window.findChild<QDockWidget*>(QStringLiteral("dock-") + panel);
    if (dock == nullptr)
        return nullptr;
    dock->setFloating(true);
    dock->show();
    if (!size.isEmpty())
        dock->resize(size);
    return dock->widget();
}

void ScreenshotRun::look(const FramePtr& frame) {
    Session& session = m_window.session();
    if (session.program().isForeign())
        m_settle.start(); // no frame will arrive
    if (!frame || session.program().isReading())
        return;
    const std::size_t wanted =
        std::min(m_request.block.value_or(session.program().blockCount()), session.program().blockCount());
    if (!m_sought) {
        m_sought = true;
        if (m_request.panel == kPlots && wanted == session.program().blockCount())
            session.playback().measure(); // otherwise there would be nothing in some of them
        else
            session.playback().seek(wanted);
    }
    m_reached = frame->block == wanted;
    if (m_reached && frame->atRest)
        m_settle.start();
    else
        m_settle.stop();
}

void ScreenshotRun::reachLimit() {
    if (m_reached)
        take(); // while its surface is being refined
    else
        giveUp(m_sought ? "the requested block was not reached in 180 s" : "no stock to show after 180 s");
}

void ScreenshotRun::take() {
    if (!m_shown->isVisible()) { // a panel that was behind another tab updates itself when it is shown
        m_shown->show();
        m_settle.start();
        return;
    }
    const PartHub& part = m_window.session().part();
    if (part.isReading() || part.progress()) {
        m_settle.start();
        return;
    }
    const QPixmap picture = m_shown->grab();
    const auto* view = qobject_cast<const Viewport*>(&m_window.viewport());
    if (view != nullptr && view->isVisible() && !view->atRest()) { // it is still being uploaded
        m_settle.start();
        return;
    }
    if (picture.save(m_request.file, "PNG", kSmallestFile))
        QCoreApplication::exit(0);
    else
        giveUp("the file cannot be written");
}

void ScreenshotRun::giveUp(const char* reason) {
    cli::printFinding("proveout", command_line_finding::kScreenshotFailed, {reason});
    QCoreApplication::exit(kFailed);
}

} // namespace proveout
