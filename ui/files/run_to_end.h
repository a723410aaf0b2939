// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <QDialog>

#include "ui/session/session.h"

class QProgressBar;

namespace proveout {

/// Whether the newest frame is not the end of the program: what is exported then is the stock in between.
[[nodiscard]] bool isHalfRun(const Session& session);
/// "stock after block 12 of 60"; empty at the end of the program.
[[nodiscard]] QString momentText(const Session& session);

/// Asks what to do with a program that is half run, and runs it to its end where that is wanted: with
/// progress, and cancelled at any time. False where nothing shall be exported. UI thread; returns when all
/// that is through.
[[nodiscard]] bool settleHalfRun(QWidget& parent, Session& session);

/// Runs the program to its end while it is open; accepted there, rejected where it was cancelled or failed.
class RunToEnd final : public QDialog {
    Q_OBJECT

public:
    RunToEnd(Session& session, QWidget* parent);

    void reject() override;

private:
    void look();
    void showProgress();

    Session& m_session;
    QProgressBar* m_progress;
    std::shared_ptr<const Program> m_sought; ///< whose end is on the way
};

} // namespace proveout
