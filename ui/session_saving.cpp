// SPDX-License-Identifier: GPL-3.0-or-later
// The files of the session: saved, read again, watched, and work that was kept without them.
#include <utility>

#include <QFileInfo>

#include "ui/file_paths.h"
#include "ui/session.h"

namespace proveout {

bool Session::save() {
    if (document().path.empty())
        return false;
    const bool text = document().modified;
    const bool job = jobModified();
    const Result<void> written = m_job.save();
    return saved(written, text && !document().modified, job && !jobModified());
}

bool Session::saveAs(const QString& file) {
    const Result<void> written = m_job.saveTextAs(file);
    return saved(written, written.has_value(), false);
}

bool Session::saveJobAs(const QString& file) {
    const Result<void> written = m_job.saveJobAs(file);
    return saved(written, false, written.has_value());
}

std::optional<DiskConflict> Session::conflict() const {
    std::optional<DiskConflict> found;
    if (document().modified)
        found = conflict(FilePart::text);
    return !found && jobModified() ? conflict(FilePart::job) : found;
}

bool Session::saveBeside(FilePart part) {
    const Result<void> written = m_job.saveBeside(part);
    return saved(written, written.has_value() && part == FilePart::text,
                 written.has_value() && part == FilePart::job);
}

void Session::detachJob() {
    m_job.detachJob();
    emit documentChanged();
}

bool Session::saved(const Result<void>& written, bool text, bool job) {
    if (text) {
        m_watch.watch(toQString(document().path)); // from what we have written on
        emit fileWritten();
    }
    if (job) {
        m_jobWatch.watch(jobFile());
        emit jobChangedOnDisk(false);
    }
    emit documentChanged();
    return told(written);
}

/// What has happened to the files since they were read is reported too.
void Session::watchFiles() {
    m_watch.watch(toQString(document().path), document().onDisk);
    m_jobWatch.watch(jobFile(), m_job.jobState());
    emit jobChangedOnDisk(false);
}

bool Session::told(const Result<void>& result) {
    tell(result ? Diagnostics() : result.error());
    return result.has_value();
}

void Session::reload() {
    m_reader.readText(document().path, [this](Result<Document> text) { textRead(std::move(text)); });
}

void Session::textRead(Result<Document> text) {
    if (!text)
        m_job.keepMine();
    else if (text->path == document().path) { // else it was saved elsewhere in the meantime
        m_job.replaceText(*text);
        m_watch.watch(toQString(document().path), document().onDisk);
        emit textReplaced();
        interpret();
    }
    told(text ? Result<void>() : tl::unexpected(text.error()));
    emit documentChanged();
}

void Session::keepMine() {
    stopOpening();
    if (const auto present = conflict(FilePart::text))
        m_job.acceptDisk(*present);
    m_job.keepMine();
    emit documentChanged();
}

/// A file that was written again with the same content is no news.
void Session::watchedFileChanged() {
    const bool quick = document().text.size() <= kEditableBytes;
    const Result<DiskState> state =
        quick ? m_job.textOnDisk().compare(document().path) : Result<DiskState>(DiskState::changed);
    if (state && *state == DiskState::same) {
        emit fileWritten();
        return;
    }
    if (!QFileInfo::exists(toQString(document().path)))
        keepMine(); // the window holds the last copy
    emit fileChangedOnDisk();
}

// The job file.

void Session::reloadJob() {
    m_reader.open(jobFile(), [this, file = jobFile()](Result<JobDocument> read) {
        if (read && file == jobFile()) {
            const bool sameProgram = read->text().path == document().path;
            if (!sameProgram && !document().modified)
                return adopt(std::move(*read));
            const DecimationParameters before = parameters();
            m_job.replaceJob(*read);
            m_history.clear();
            emit jobReplaced();
            if (!sameProgram)
                m_job.keepMyJob(); // it must name the program of the window
            m_jobWatch.watch(file, m_job.jobState());
            emit jobChangedOnDisk(false);
            interpret();
            tellSetup(before);
            emit machineChanged();
            askForTimes();
        }
        tell(read ? m_job.warnings() : read.error());
        emit documentChanged();
    });
}

void Session::keepMyJob() {
    if (const auto present = conflict(FilePart::job))
        m_job.acceptDisk(*present);
    m_job.keepMyJob();
    emit jobChangedOnDisk(false);
    emit documentChanged();
}

void Session::watchedJobChanged() {
    const Result<DiskState> state = m_job.jobOnDisk().compare(toPath(jobFile()));
    if (state && *state == DiskState::missing)
        m_job.keepMyJob(); // the window holds the last copy
    emit jobChangedOnDisk(!state || *state != DiskState::same);
    emit documentChanged();
}

// Kept work.

void Session::restore(const KeptWork& kept, std::function<void()> done) {
    m_reader.restore(kept, [this, done = std::move(done)](Result<JobDocument> job) {
        if (!job)
            return tell(job.error());
        adopt(std::move(*job));
        tell(m_job.warnings());
        if (conflict(FilePart::text))
            emit fileChangedOnDisk();
        if (conflict(FilePart::job))
            emit jobChangedOnDisk(true);
        done();
    });
}

} // namespace proveout
