// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include <QObject>
#include <QPointer>
#include <QSize>
#include <QString>
#include <QTimer>

#include "ui/window/main_window.h"

namespace proveout {

/// The content of a screenshot, and its file.
struct ScreenshotRequest {
    QString file;                     ///< PNG
    std::optional<std::size_t> block; ///< empty: the end of the program
    /// A single panel, by the name of its page in the user guide ("setup", "view"); empty: the whole window.
    QString panel;
    QSize size; ///< of the content; empty: the default size
};

/// Takes a screenshot as soon as the requested block is drawn with its refined surface, then quits the
/// application: exit code 0, or 3 with the reason on stderr if that was not possible in time.
class ScreenshotRun final : public QObject {
    Q_OBJECT

public:
    ScreenshotRun(MainWindow& window, const ScreenshotRequest& request);

private:
    [[nodiscard]] QWidget* shownAlone(const QString& panel, QSize size);
    void look(const FramePtr& frame);
    void take();
    void reachLimit();
    void giveUp(const char* reason);

    MainWindow& m_window;
    ScreenshotRequest m_request;
    QPointer<QWidget> m_shown; ///< null: the panel does not exist
    bool m_sought = false;
    bool m_reached = false;
    QTimer m_settle; ///< layout and painting are complete when no frame has arrived for a moment
    QTimer m_limit;
};

} // namespace proveout
