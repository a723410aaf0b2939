// SPDX-License-Identifier: GPL-3.0-or-later
// Backups of sessions in case they end unexpectedly: one folder per session, below a common root.
#pragma once

#include <memory>
#include <vector>

#include <QByteArray>
#include <QDateTime>
#include <QLockFile>
#include <QString>
#include <QStringList>

#include "core/base/diagnostic.h"
#include "ui/document/job_document.h"

namespace proveout {

/// What belongs to a session besides its files. Value type.
struct SessionState {
    QStringList breakpoints; ///< as KeptBreakpoints::written()
    QByteArray layout;       ///< as MainWindow::layout()

    friend bool operator==(const SessionState&, const SessionState&) = default;
};

/// A session as it was backed up. Value type.
struct KeptSession {
    KeptWork work;
    SessionState state;
    QDateTime time;

    /// Whether the session contains anything that is not saved in another file.
    [[nodiscard]] bool isUnsaved() const { return !work.keptText.empty() || work.jobModified; }
};

/// Writes the unsaved parts of `document`, and which files they belong to, into the folder. The record is
/// written last, and each file appears complete or not at all. Any thread; only one thread at a time per
/// folder. Errors: a file cannot be written.
[[nodiscard]] Result<void> keepSession(const QString& folder, const JobDocument& document,
                                       const SessionState& state);
/// If the record is damaged, the text is read as that of a new program. Errors: neither record nor text
/// exists.
[[nodiscard]] Result<KeptSession> readKeptSession(const QString& folder);

/// A new folder below the root that is reserved for this process until it is removed or the process ends,
/// even by a crash. Movable.
class SessionFolder {
public:
    /// Errors: the folder cannot be created.
    [[nodiscard]] static Result<SessionFolder> create(const QString& root);
    /// Folders left by processes of this computer that have ended. Folders of other computers are not
    /// included.
    [[nodiscard]] static std::vector<SessionFolder> abandoned(const QString& root);

    [[nodiscard]] const QString& path() const { return m_path; }
    /// Removes the folder with its content.
    void remove();

private:
    SessionFolder(QString path, std::unique_ptr<QLockFile> lock);

    QString m_path;
    std::unique_ptr<QLockFile> m_lock;
};

} // namespace proveout
