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

/// Opening, saving and exporting with their file dialogs, and the only questions that interrupt the user:
/// about unsaved changes, about a file that is newer on disk than in the window, and about an export still in
/// progress when the window closes. UI thread.
class FileFlow final : public QObject {
    Q_OBJECT

public:
    /// `window` is the parent of the dialogs.
    FileFlow(Session& session, QWidget& window);

    [[nodiscard]] RecentFiles& recent() { return m_recent; }
    /// Opens a file after asking about unsaved changes, like Session::openFile(). False if the user declines.
    bool open(const QString& file);
    void openByDialog();
    void newFile();
    /// While a save of a long text is in progress, it is repeated afterwards with what has changed meanwhile.
    bool save();
    bool saveAs();
    bool saveJobAs();
    /// Asks for a file name and saves the remaining stock for the next setup.
    void saveStock();
    void exportByDialog(bool decimated);
    /// Lists unsaved changes and offers to save them. False: the user wants to keep working on them.
    bool mayDiscard();
    /// Whether the window may close: asks about an export in progress, then like mayDiscard(). If the user
    /// waits for the export, or a save is in progress, the window must stay open until closeWanted() is
    /// emitted after the file is written.
    bool mayClose();

    /// The file that a drop would open; empty, with `reason` set, if the drop cannot be used.
    static QString droppedFile(const QMimeData& data, QString& reason);

signals:
    void closeWanted();
    /// A file was written; the message is e.g. "Saved bracket.nc".
    void saved(const QString& message);
    /// A new empty program was created.
    void newBegun();

private:
    enum class ExportAnswer { stay, wait, drop, written };

    ExportAnswer askAboutExport();
    void askAboutOutside(const QString& job, const std::vector<std::filesystem::path>& files);
    /// Asks about each file that is newer on disk than in the window. False: the user cancelled.
    bool settle(const std::function<std::optional<DiskConflict>()>& next);
    void collectChanges();
    bool saveNow();
    [[nodiscard]] bool isSaving() const;
    void closeAfterSave();
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
    bool m_saving = false;
    bool m_closeAfterSave = false;
    bool m_saveAgain = false; ///< wanted while a save was in progress
};

} // namespace proveout
