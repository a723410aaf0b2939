// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include <QString>
#include <QWidget>

#include "ui/document/recent_files.h"
#include "ui/program/export_job.h"
#include "ui/session/session.h"

class QMimeData;

namespace proveout {

/// Opening, saving and exporting with their file dialogs, and the only questions that interrupt: about
/// unsaved changes, about a file that is newer on the disk than in the window, and about an export that is
/// still being written when the window closes. UI thread.
class FileFlow final : public QObject {
    Q_OBJECT

public:
    /// `window` is the parent of dialogs.
    FileFlow(Session& session, QWidget& window);

    [[nodiscard]] RecentFiles& recent() { return m_recent; }
    /// Opens a file after asking about unsaved changes, as Session::openFile() does. False where the user
    /// does not want to.
    bool open(const QString& file);
    void openByDialog();
    void newFile();
    bool save();
    bool saveAs();
    bool saveJobAs();
    /// Asks where, and saves what is left of the stock for the next set-up.
    void saveStock();
    void exportByDialog(bool decimated);
    /// Names what is not on the disk and offers to save it. False: the user wants to go on with it.
    bool mayDiscard();
    /// Whether the window may close: asks about an export under way, then as mayDiscard(). Where the user
    /// waits for the export, it may not yet, and closeWanted() comes when the file is written.
    bool mayClose();

    /// What a drop would open; empty with `reason` set where it cannot be used.
    static QString droppedFile(const QMimeData& data, QString& reason);

signals:
    void closeWanted();
    /// Something was written, e.g. "Saved bracket.nc".
    void saved(const QString& message);
    /// An empty program was begun.
    void newBegun();

private:
    enum class ExportAnswer { stay, wait, drop, written };

    ExportAnswer askAboutExport();
    void askAboutOutside(const QString& job, const std::vector<std::filesystem::path>& files);
    /// Goes on when no file is newer than what the window has read, or the user has said what to do with it.
    bool settle(const std::function<std::optional<DiskConflict>()>& next);
    void collectChanges();
    bool saveFiles();
    bool saveTextAs(const QString& file);
    void reportSaved(bool text, bool job);
    [[nodiscard]] QString startFolder() const;
    [[nodiscard]] QString unsaved() const;
    [[nodiscard]] QString titled(const QString& title) const;

    Session& m_session;
    QWidget& m_window;
    RecentFiles m_recent;
    bool m_closeAfterExport = false;
};

} // namespace proveout
