// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include <QObject>
#include <QString>

#include "core/base/diagnostic.h"
#include "core/decimation/regions/parameters.h"
#include "ui/document/document_reader.h"
#include "ui/document/file_watch.h"
#include "ui/document/job_document.h"

namespace proveout {

class ProblemsHub;
class WorkHub;

/// The open document: the NC text, and setup and parameters as its job has them, with their files. Thread:
/// the UI thread; files are read in the background. Errors go to the problems.
class DocumentHub final : public QObject {
    Q_OBJECT

public:
    /// Both outlive it.
    DocumentHub(ProblemsHub& problems, WorkHub& work);

    /// False until a file was opened or a new one begun: the start page is shown then.
    [[nodiscard]] bool isOpen() const { return m_isOpen; }
    [[nodiscard]] const Document& text() const { return m_job.text(); }
    /// The job file that setup and parameters came from or were saved to; empty where there is none.
    [[nodiscard]] const QString& jobFile() const { return m_job.jobFile(); }
    /// Whether text, or setup and parameters of a job, hold changes that are not on the disk.
    [[nodiscard]] bool modified() const { return m_job.modified(); }
    /// Whether setup or parameters hold changes that no job file has.
    [[nodiscard]] bool jobModified() const { return m_job.jobModified(); }
    /// Text, setup and parameters with their files, as one value.
    [[nodiscard]] const JobDocument& job() const { return m_job; }
    /// For the hubs of the session; panels change setup and parameters through JobHub.
    [[nodiscard]] JobDocument& editJob() { return m_job; }
    /// Whether a file is being read whose content will replace the document, or its text.
    [[nodiscard]] bool isOpening() const { return m_reader.isReading(); }

    /// Opens an NC program or a `.proveout` job: it is read in the background, and takes the place of the
    /// document when it is there whole (opened()). What went wrong is in the problems; the open document then
    /// stays as it was. Unsaved changes are the caller's to ask about before; a change of the document while
    /// the file is read stops the opening, so that none is lost. The newest file wins.
    void openFile(const QString& file);
    void newFile();
    /// Opens kept work as openFile() opens a file; `done` is called when it is there.
    void restore(const KeptWork& kept, std::function<void()> done);
    /// The document is about to be changed: an opening under way would lose the change, and is stopped.
    void stopOpening();

    /// Writes text and job to where they came from. False where that failed, where there is no path yet, and
    /// where a file has been changed by somebody else: see conflict().
    bool save();
    bool saveAs(const QString& file);
    bool saveJobAs(const QString& file);
    /// What save() would overwrite although it is newer than what the window has read: the files are compared
    /// now, by content. Nothing where there is no such, or no longer.
    [[nodiscard]] std::optional<DiskConflict> conflict() const;
    [[nodiscard]] std::optional<DiskConflict> conflict(FilePart part) const { return m_job.conflict(part); }
    /// The next save may overwrite it.
    void acceptDisk(const DiskConflict& conflict) { m_job.acceptDisk(conflict); }
    /// Saves a part under a new name beside its file, which stays as it is. False where that failed.
    bool saveBeside(FilePart part);
    /// Setup and parameters stay, but no longer belong to a job file.
    void detachJob();
    /// Reads the text again from the disk, in the background as openFile() does.
    void reload();
    /// Leaves the text as it is although the file has changed; it counts as modified, and may be saved over
    /// what the file holds now.
    void keepMine();
    /// The same of setup and parameters, for the job file.
    void reloadJob();
    void keepMyJob();
    /// From now on changes of the files on the disk are reported, those since they were read too.
    void watchFiles();

    /// The user replaced the bytes [offset, offset + removed) of the text.
    void applyEdit(std::size_t offset, std::size_t removed, std::string_view inserted);
    /// The editor's undo reached or left the saved text.
    void setTextModified(bool modified);

signals:
    /// Another document, or the same one under another name or with another modified state.
    void changed();
    /// The text was replaced as a whole (opened, reloaded): views load it again.
    void textReplaced();
    /// openFile() is through: the document is that of the file.
    void opened(const QString& file);
    /// A job was not opened, because it names files outside its folder that the user has not allowed.
    void outsideFilesNamed(const QString& job, const std::vector<std::filesystem::path>& files);
    /// The file of the document is gone, or no longer what was read or written.
    void fileChangedOnDisk();
    /// The file of the document is again what the window holds.
    void fileWritten();
    /// The job file is no longer what was read or written; false: it is again.
    void jobChangedOnDisk(bool changed);
    /// For the session, before it reports the changes: another document is open.
    void adopted();
    /// For the session: an edit of the user is in text().
    void edited();
    /// For the session: setup, parameters and machine were read again; the parameters before.
    void jobReread(const DecimationParameters& before);

private:
    void adopt(JobDocument job);
    void refuseOpening(const QString& file, const Diagnostics& errors);
    bool saved(const Result<void>& written, bool textToo, bool jobToo);
    bool reported(const Result<void>& result);
    void textRead(const Result<Document>& read);
    void jobRead(const QString& file, Result<JobDocument> read);
    void watchedFileChanged();
    void watchedJobChanged();

    ProblemsHub& m_problems;
    JobDocument m_job;
    bool m_isOpen = false;
    FileWatch m_watch;
    FileWatch m_jobWatch;
    DocumentReader m_reader;
};

} // namespace proveout
