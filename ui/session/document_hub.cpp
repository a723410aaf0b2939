// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/document_hub.h"

#include <string>
#include <utility>

#include <QFileInfo>

#include "core/formats/job_findings.h"
#include "core/verification/findings/window_findings.h"
#include "ui/document/file_paths.h"
#include "ui/document/job_permissions.h"
#include "ui/session/problems_hub.h"
#include "ui/session/work_hub.h"

namespace proveout {

DocumentHub::DocumentHub(ProblemsHub& problems, WorkHub& work) : m_problems(problems) {
    work.setCancel(WorkKind::opening, [this] { m_reader.cancel(); });
    connect(&m_reader, &DocumentReader::progressChanged, this,
            [this, &work] { work.set(WorkKind::opening, m_reader.progress()); });
    connect(&m_writer, &DocumentWriter::progressed, this,
            [&work](std::optional<double> done) { work.set(WorkKind::saving, done); });
    m_writer.pause(m_watch);
    m_writer.pause(m_jobWatch);
    connect(&m_watch, &FileWatch::changed, this, &DocumentHub::watchedFileChanged);
    connect(&m_jobWatch, &FileWatch::changed, this, &DocumentHub::watchedJobChanged);
}

// Opening

void DocumentHub::openFile(const QString& file) {
    m_reader.open(file, [this, file](Result<JobDocument> job) {
        if (!job)
            return refuseOpening(file, job.error());
        adopt(std::move(*job));
        m_problems.report(m_job.warnings());
        emit opened(file);
    });
}

/// The receiver of the signal opens the job again if the user allows the files.
void DocumentHub::refuseOpening(const QString& file, const Diagnostics& errors) {
    m_problems.report(errors);
    std::vector<std::filesystem::path> outside;
    bool otherwise = false; // whether there are other errors, so that it cannot be opened in any case
    for (const Diagnostic& error : errors) {
        if (hasIdOf(error, job_finding::kJobOutside))
            outside.emplace_back(error.arguments.at(1).text());
        else
            otherwise = otherwise || error.severity == Severity::error; // job warnings are included
    }
    if (!otherwise)
        emit outsideFilesNamed(file, outside);
}

void DocumentHub::newFile() {
    m_reader.cancel();
    adopt({});
}

void DocumentHub::restore(const KeptWork& kept, std::function<void()> done) {
    m_reader.restore(kept, [this, done = std::move(done)](Result<JobDocument> job) {
        if (!job)
            return m_problems.report(job.error());
        adopt(std::move(*job));
        m_problems.report(m_job.warnings());
        if (m_job.conflict(FilePart::text))
            emit fileChangedOnDisk();
        if (m_job.conflict(FilePart::job))
            emit jobChangedOnDisk(true);
        done();
    });
}

void DocumentHub::adopt(JobDocument job) {
    m_job = std::move(job);
    m_writer.otherOpened();
    m_isOpen = true;
    emit adopted();
}

void DocumentHub::stopOpening() {
    if (!m_reader.isReading())
        return;
    m_reader.cancel();
    m_problems.report(failure(window_finding::kOpeningStopped).value());
}

// Text

void DocumentHub::applyEdit(std::size_t offset, std::size_t removed, std::string_view inserted) {
    stopOpening();
    m_job.edit(offset, removed, inserted);
    emit edited();
}

void DocumentHub::setTextModified(bool modified) {
    if (m_job.setTextModified(modified))
        emit changed();
}

// Saving

bool DocumentHub::save() {
    return !text().path.empty() && write([](JobDocument& job) { return job.save(); });
}

bool DocumentHub::saveAs(const QString& file) {
    return write([file](JobDocument& job) { return job.saveTextAs(file); }, FilePart::text);
}

bool DocumentHub::saveJobAs(const QString& file) {
    return write([file](JobDocument& job) { return job.saveJobAs(file); }, FilePart::job);
}

bool DocumentHub::saveBeside(FilePart part) {
    return write([part](JobDocument& job) { return DocumentWriter::saveBeside(job, part); }, part);
}

std::optional<DiskConflict> DocumentHub::conflict() {
    std::optional<DiskConflict> found;
    if (text().modified)
        found = conflict(FilePart::text);
    return !found && jobModified() ? conflict(FilePart::job) : found;
}

void DocumentHub::detachJob() {
    m_job.detachJob();
    emit changed();
}

bool DocumentHub::write(const DocumentWriter::Save& save, std::optional<FilePart> part) {
    bool all = false;
    m_writer.save(m_job, save, part, [&](const auto& written) { all = saved(written); });
    return all;
}

bool DocumentHub::saved(const DocumentWriter::Written& written) {
    if (!written.open)
        return reported(written.result);
    if (written.text) {
        m_watch.watch(toQString(text().path)); // watches from the state that was just written
        emit fileWritten();
    }
    if (written.job) {
        m_jobWatch.watch(jobFile());
        allowOutside(jobFile(), outsideFiles(toPath(jobFile()), m_job.job())); // saving it implies trust
        emit jobChangedOnDisk(false);
    }
    emit changed();
    return reported(written.result);
}

bool DocumentHub::reported(const Result<void>& result) {
    m_problems.report(result ? Diagnostics() : result.error());
    return result.has_value();
}

// Files on disk

void DocumentHub::watchFiles() {
    m_watch.watch(toQString(text().path), text().onDisk);
    m_jobWatch.watch(jobFile(), m_job.jobState());
    emit jobChangedOnDisk(false);
}

void DocumentHub::reload() {
    m_reader.readText(text().path, [this](const Result<Document>& read) { textRead(read); });
}

void DocumentHub::textRead(const Result<Document>& read) {
    if (!read)
        m_job.keepMine();
    else if (read->path == text().path) { // otherwise the document was saved elsewhere in the meantime
        m_job.replaceText(*read);
        m_watch.watch(toQString(text().path), text().onDisk);
        emit textReplaced();
    }
    reported(read ? Result<void>() : tl::unexpected(read.error()));
    emit changed();
}

void DocumentHub::keepMine() {
    stopOpening();
    if (const auto present = m_job.conflict(FilePart::text))
        m_job.acceptDisk(*present);
    m_job.keepMine();
    emit changed();
}

/// A file that was written again with the same content is not reported, unless comparing it would take long.
void DocumentHub::watchedFileChanged() {
    constexpr std::size_t kQuicklyCompared = 10'000'000; // bytes
    const bool quick = text().text.size() <= kQuicklyCompared;
    const Result<DiskState> state =
        quick ? m_job.textOnDisk().compare(text().path) : Result<DiskState>(DiskState::changed);
    if (state && *state == DiskState::same) {
        emit fileWritten();
        return;
    }
    if (!QFileInfo::exists(toQString(text().path)))
        keepMine(); // the window has the only copy
    emit fileChangedOnDisk();
}

void DocumentHub::reloadJob() {
    m_reader.open(jobFile(),
                  [this, file = jobFile()](Result<JobDocument> read) { jobRead(file, std::move(read)); });
}

void DocumentHub::jobRead(const QString& file, Result<JobDocument> read) {
    if (read && file == jobFile()) {
        const bool sameProgram = read->text().path == text().path;
        if (!sameProgram && !text().modified)
            return adopt(std::move(*read));
        const DecimationParameters before = m_job.parameters();
        m_job.replaceJob(*read);
        if (!sameProgram)
            m_job.keepMyJob(); // the job must name the program in the window
        m_jobWatch.watch(file, m_job.jobState());
        emit jobChangedOnDisk(false);
        emit jobReread(before);
    }
    m_problems.report(read ? m_job.warnings() : read.error());
    emit changed();
}

void DocumentHub::keepMyJob() {
    if (const auto present = m_job.conflict(FilePart::job))
        m_job.acceptDisk(*present);
    m_job.keepMyJob();
    emit jobChangedOnDisk(false);
    emit changed();
}

void DocumentHub::watchedJobChanged() {
    const Result<DiskState> state = m_job.jobOnDisk().compare(toPath(jobFile()));
    if (state && *state == DiskState::missing)
        m_job.keepMyJob(); // the window has the only copy
    emit jobChangedOnDisk(!state || *state != DiskState::same);
    emit changed();
}

} // namespace proveout
