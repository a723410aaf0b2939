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
#include "ui/document/document_writer.h"
#include "ui/document/file_watch.h"
#include "ui/document/job_document.h"

namespace proveout {

class ProblemsHub;
class WorkHub;

/// The open document: the NC text, and setup and parameters as in its job, with their files. Thread: the UI
/// thread; files are read in the background. Errors are added to the problems.
class DocumentHub final : public QObject {
    Q_OBJECT

public:
    /// Both must outlive this object.
    DocumentHub(ProblemsHub& problems, WorkHub& work);

    /// False until a file was opened or a new one created; the start page is shown until then.
    [[nodiscard]] bool isOpen() const { return m_isOpen; }
    [[nodiscard]] const Document& text() const { return m_job.text(); }
    /// The job file that setup and parameters were read from or saved to; empty if there is none.
    [[nodiscard]] const QString& jobFile() const { return m_job.jobFile(); }
    /// Whether the text, or setup and parameters of a job, have unsaved changes.
    [[nodiscard]] bool modified() const { return m_job.modified(); }
    /// Whether setup or parameters have changes that are not in a job file.
    [[nodiscard]] bool jobModified() const { return m_job.jobModified(); }
    /// Text, setup and parameters with their files, as one value.
    [[nodiscard]] const JobDocument& job() const { return m_job; }
    /// Only for the hubs of the session; panels change setup and parameters through JobHub.
    [[nodiscard]] JobDocument& editJob() { return m_job; }
    /// Whether a file is being read whose content will replace the document or its text.
    [[nodiscard]] bool isOpening() const { return m_reader.isReading(); }

    /// Opens an NC program or a `.proveout` job. It is read in the background and replaces the document once
    /// it is complete (opened()). Errors are added to the problems, and the open document then stays
    /// unchanged. The caller must ask about unsaved changes first; a change of the document during reading
    /// cancels the opening, so that no change is lost. The newest request wins.
    void openFile(const QString& file);
    void newFile();
    /// Opens backed-up work like openFile() opens a file; `done` is called when it is complete.
    void restore(const KeptWork& kept, std::function<void()> done);
    /// Cancels an opening in progress, because the document is about to change and opening would lose the
    /// change.
    void stopOpening();

    /// Writes text and job to their files (DocumentWriter). False on an error, if there is no path yet, if
    /// another program has changed a file: see conflict(), or if a save is in progress.
    bool save();
    bool saveAs(const QString& file);
    bool saveJobAs(const QString& file);
    /// The file that save() would overwrite although it is newer than what the window has read; compares the
    /// contents now. Empty if there is no such file.
    [[nodiscard]] std::optional<DiskConflict> conflict();
    [[nodiscard]] std::optional<DiskConflict> conflict(FilePart part) {
        return m_writer.conflict(m_job, part);
    }
    /// Allows the next save to overwrite the file.
    void acceptDisk(const DiskConflict& conflict) { m_job.acceptDisk(conflict); }
    /// Saves a part under a new name next to its file, which stays unchanged. False on an error.
    bool saveBeside(FilePart part);
    [[nodiscard]] DocumentWriter& writer() { return m_writer; }
    /// Setup and parameters stay, but no longer belong to a job file.
    void detachJob();
    /// Reads the text from disk again, in the background like openFile().
    void reload();
    /// Keeps the text although the file has changed; it counts as modified, and a save may overwrite the new
    /// content of the file.
    void keepMine();
    /// The same for setup and parameters and the job file.
    void reloadJob();
    void keepMyJob();
    /// From now on changes of the files on disk are reported, including those since they were read.
    void watchFiles();

    /// The user has replaced the bytes [offset, offset + removed) of the text.
    void applyEdit(std::size_t offset, std::size_t removed, std::string_view inserted);
    /// The editor's undo has reached or left the saved text.
    void setTextModified(bool modified);

signals:
    /// Another document, or a new name or modified state of this one.
    void changed();
    /// The complete text was replaced (opened, reloaded): views must load it again.
    void textReplaced();
    /// openFile() has finished: the document is that of the file.
    void opened(const QString& file);
    /// A job was not opened because it names files outside its folder that the user has not allowed.
    void outsideFilesNamed(const QString& job, const std::vector<std::filesystem::path>& files);
    /// The file of the document was removed or has changed since it was read or written.
    void fileChangedOnDisk();
    /// The file of the document matches the window again.
    void fileWritten();
    /// The job file has changed since it was read or written; false: it matches again.
    void jobChangedOnDisk(bool changed);
    /// For the session, emitted before the change signals: another document is open.
    void adopted();
    /// For the session: text() contains an edit by the user.
    void edited();
    /// For the session: setup, parameters and machine were read again; `before` is the previous parameters.
    void jobReread(const DecimationParameters& before);

private:
    void adopt(JobDocument job);
    void refuseOpening(const QString& file, const Diagnostics& errors);
    bool write(const DocumentWriter::Save& save, std::optional<FilePart> part = {});
    bool saved(const DocumentWriter::Written& written);
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
    DocumentWriter m_writer;
};

} // namespace proveout
