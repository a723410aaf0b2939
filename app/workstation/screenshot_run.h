// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include <QObject>
#include <QString>
#include <QTimer>

#include "ui/window/main_window.h"

namespace proveout {

/// Takes a picture of the window as soon as the wanted block is drawn, then ends the application: exit code
/// 0, or 3 and the reason on standard error where that did not happen in time.
class ScreenshotRun final : public QObject {
    Q_OBJECT

public:
    /// `block`: none for the end of the program.
    ScreenshotRun(MainWindow& window, const QString& picture, std::optional<std::size_t> block);

private:
    void look(const FramePtr& frame);
    void take();
    void giveUp(const char* reason);

    MainWindow& m_window;
    QString m_picture;
    std::optional<std::size_t> m_block;
    bool m_sought = false;
    QTimer m_settle; ///< layout and paint are over when no other frame came for a moment
    QTimer m_limit;
};

} // namespace proveout
