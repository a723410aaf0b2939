// SPDX-License-Identifier: GPL-3.0-or-later
// The files of the session: saved, read again, watched, and work that was kept without them.
#include <memory>
#include <new>
#include <utility>

#include <QFileInfo>

#include "core/base/text.h"
#include "core/formats/stock_shapes.h"
#include "core/simulation/setup/automatic_grid.h"
#include "ui/file_paths.h"
#include "ui/job_permissions.h"
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
        allowOutside(jobFile(), outsideFiles(toPath(jobFile()), m_job.job())); // who has saved it trusts it
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

// The file of the stock.

void Session::watchStock() {
    const StockShape& shape = setup().shape;
    if (m_watchedStock == shape.body)
        return;
    m_watchedStock = shape.body;
    m_stockReading.cancel();
    const bool fromFile = shape.body != nullptr && !shape.file.empty();
    m_stockWatch.watch(fromFile ? toQString(shape.file) : QString(), shape.fileState);
    tellStockFile(false);
}

/// It may be again what was read.
void Session::watchedStockChanged() {
    tellStockFile(stateOf(setup().shape.file) != setup().shape.fileState);
}

void Session::tellStockFile(bool changed) {
    m_stockFile.clear();
    if (changed) {
        Diagnostic warning;
        warning.severity = Severity::warning;
        warning.unverified = true;
        warning.id = "stock-changed-on-disk";
        warning.text = PROVEOUT_TEXT("Core", "The file of the stock has changed on disk; the simulation "
                                             "starts from what it held before.");
        warning.hint = PROVEOUT_TEXT("Core", "Reload the stock in the setup, or keep it as it is.");
        warning.file = setup().shape.file.string();
        m_stockFile = {warning};
    }
    refreshProblems();
    emit stockChangedOnDisk(changed);
}

void Session::reloadStock() {
    m_stockReading.start([this, before = m_job.setup()](const NewestTask::Reply& reply) {
        StockSpec spec{before->stock, before->shape};
        Result<void> done;
        try {
            done = makeStock(spec, before->stock.corner);
        } catch (const std::bad_alloc&) {
            done = failure("stock-out-of-memory",
                           PROVEOUT_TEXT("Core", "The stock needs more memory than there is."));
        }
        reply.post([this, spec, done] {
            if (!done)
                return tell(done.error());
            Setup read = setup();
            const Vec3 corner = read.stock.corner; // it may have been moved in the meantime
            read.stock = spec.box;
            read.stock.corner = corner;
            read.shape = spec.shape;
            takeStock(read);
        });
    });
}

/// No change of the job, which names the same file.
void Session::takeStock(const Setup& read) {
    const JobValues before = m_job.values();
    Setup fitted = read;
    if (m_program)
        fitted.spacing = gridSpacing(fitted, *m_program, gridLimits(parameters()));
    if (const Result<void> fits = checkMap(fitted); !fits)
        return tell(fits.error());
    m_job.fitSetup(std::make_shared<const Setup>(std::move(fitted)));
    runOn(*before.setup);
    tellSetup(before.parameters);
    emit documentChanged();
}

void Session::keepStock() {
    tellStockFile(false);
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
