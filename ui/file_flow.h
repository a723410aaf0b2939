// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>

#include "ui/export_job.h"
#include "ui/recent_files.h"
#include "ui/session.h"

class QMimeData;

namespace proveout {

/// Opening, saving and exporting with their file dialogs, and the question about unsaved changes, which is
/// the only one that interrupts. UI thread.
class FileFlow final : public QObject {
    Q_OBJECT

public:
    /// `window` is the parent of dialogs.
    FileFlow(Session& session, QWidget& window);

    [[nodiscard]] RecentFiles& recent() { return m_recent; }
    /// Opens a file after asking about unsaved changes. False where it was not opened.
    bool open(const QString& file);
    void openByDialog();
    void newFile();
    bool save();
    bool saveAs();
    bool saveJobAs();
    void exportByDialog(bool decimated);
    /// Names what is not on the disk and offers to save it. False: the user wants to go on with it.
    bool mayDiscard();

    /// What a drop would open; empty with `reason` set where it cannot be used.
    static QString droppedFile(const QMimeData& data, QString& reason);

private:
    [[nodiscard]] QString startFolder() const;
    [[nodiscard]] QString unsaved() const;

    Session& m_session;
    QWidget& m_window;
    RecentFiles m_recent;
};

} // namespace proveout
