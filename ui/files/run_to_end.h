// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <QDialog>

#include "ui/session/session.h"

class QProgressBar;

namespace proveout {

/// Whether the newest frame is before the end of the program, so that an export would contain unfinished
/// stock.
[[nodiscard]] bool isHalfRun(const Session& session);
/// "stock after block 12 of 60"; empty at the end of the program.
[[nodiscard]] QString momentText(const Session& session);

/// Asks what to do with a program that has not run to its end, and runs it there if the user wants, with
/// progress and a way to cancel. False if nothing is to be exported. UI thread; returns when all this is
/// done.
[[nodiscard]] bool settleHalfRun(QWidget& parent, Session& session);

/// Runs the program to its end while it is open; accepted at the end, rejected if cancelled or failed.
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
    std::shared_ptr<const Program> m_sought; ///< the program that is being run to its end
};

} // namespace proveout
