// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workstation/screenshot_run.h"

#include <algorithm>

#include <QCoreApplication>
#include <QPixmap>

#include "app/cli/run_command.h"
#include "core/verification/findings/command_line_findings.h"

namespace proveout {

namespace {
constexpr int kSettleMs = 700;
constexpr int kLimitMs = 180'000;
constexpr int kFailed = 3;
} // namespace

ScreenshotRun::ScreenshotRun(MainWindow& window, const QString& picture, std::optional<std::size_t> block)
    : QObject(&window), m_window(window), m_picture(picture), m_block(block) {
    m_settle.setSingleShot(true);
    m_settle.setInterval(kSettleMs);
    m_limit.setSingleShot(true);
    connect(&m_settle, &QTimer::timeout, this, &ScreenshotRun::take);
    connect(&m_limit, &QTimer::timeout, this, [this] {
        giveUp(m_sought ? "the requested block was not reached in 180 s" : "no stock to show after 180 s");
    });
    connect(&window.session().playback(), &PlaybackHub::tick, this, &ScreenshotRun::look);
    m_limit.start(kLimitMs);
    if (!window.session().document().isOpen())
        m_settle.start(); // the start page
}

void ScreenshotRun::look(const FramePtr& frame) {
    Session& session = m_window.session();
    if (session.program().isForeign())
        m_settle.start(); // there is no frame of it
    if (!frame || session.program().isReading())
        return;
    const std::size_t wanted =
        std::min(m_block.value_or(session.program().blockCount()), session.program().blockCount());
    if (!m_sought) {
        m_sought = true;
        session.playback().seek(wanted);
    }
    if (frame->block == wanted)
        m_settle.start();
}

void ScreenshotRun::take() {
    if (m_window.grab().save(m_picture))
        QCoreApplication::exit(0);
    else
        giveUp("the file cannot be written");
}

void ScreenshotRun::giveUp(const char* reason) {
    cli::printFinding("proveout", command_line_finding::kScreenshotFailed, {reason});
    QCoreApplication::exit(kFailed);
}

} // namespace proveout
