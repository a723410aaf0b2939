// SPDX-License-Identifier: GPL-3.0-or-later
// What is kept of a session in case it does not end by itself: one folder a session, below one root.
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

/// Texts with more bytes are not kept: writing them every few seconds would load the disk. They are read-only
/// anyway (kEditableBytes) and unsaved only where their file has gone.
inline constexpr std::size_t kLargestKeptText = 100'000'000;

/// What a session consists of beside its files. Value type.
struct SessionState {
    QStringList breakpoints; ///< as KeptBreakpoints::written()
    QByteArray layout;       ///< as MainWindow::layout()

    friend bool operator==(const SessionState&, const SessionState&) = default;
};

/// A session as it was kept. Value type.
struct KeptSession {
    KeptWork work;
    SessionState state;
    QDateTime time;

    /// Whether there is something that is in no other file.
    [[nodiscard]] bool isUnsaved() const { return !work.keptText.empty() || work.jobModified; }
};

/// Writes what `document` has in no other file, and what it belongs to, into the folder; the record comes
/// last, and each file appears whole or not at all. Any thread; one at a time a folder. Errors: a file cannot
/// be written.
[[nodiscard]] Result<void> keepSession(const QString& folder, const JobDocument& document,
                                       const SessionState& state);
/// Where the record is damaged, the text is that of a new program. Errors: there is neither record nor text.
[[nodiscard]] Result<KeptSession> readKeptSession(const QString& folder);

/// A new folder below the root that nobody else uses until it is removed or this process ends, however it
/// ends. Movable.
class SessionFolder {
public:
    /// Errors: the folder cannot be made.
    [[nodiscard]] static Result<SessionFolder> create(const QString& root);
    /// The folders of processes of this computer that are no longer there. Those of others stay with them.
    [[nodiscard]] static std::vector<SessionFolder> abandoned(const QString& root);

    [[nodiscard]] const QString& path() const { return m_path; }
    /// With all that is in it.
    void remove();

private:
    SessionFolder(QString path, std::unique_ptr<QLockFile> lock);

    QString m_path;
    std::unique_ptr<QLockFile> m_lock;
};

} // namespace proveout
