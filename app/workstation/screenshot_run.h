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

/// What a screenshot shows, and where it is saved.
struct ScreenshotRequest {
    QString file;                     ///< PNG
    std::optional<std::size_t> block; ///< none: the end of the program
    /// One panel alone, by the name of its page in the user guide ("setup", "view"); empty: the whole window.
    QString panel;
    QSize size; ///< of what is shown; empty: as it comes
};

/// Takes a picture of the window as soon as the wanted block is drawn, then ends the application: exit code
/// 0, or 3 and the reason on standard error where that did not happen in time.
class ScreenshotRun final : public QObject {
    Q_OBJECT

public:
    ScreenshotRun(MainWindow& window, const ScreenshotRequest& request);

private:
    [[nodiscard]] QWidget* shownAlone(const QString& panel, QSize size);
    void look(const FramePtr& frame);
    void take();
    void giveUp(const char* reason);

    MainWindow& m_window;
    ScreenshotRequest m_request;
    QPointer<QWidget> m_shown; ///< null: there is no such panel
    bool m_sought = false;
    QTimer m_settle; ///< layout and paint are over when no other frame came for a moment
    QTimer m_limit;
};

} // namespace proveout
