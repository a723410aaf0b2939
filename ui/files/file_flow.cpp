// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/files/file_flow.h"

#include <utility>

#include <QApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QUrl>

#include "core/formats/formats.h"
#include "ui/document/file_paths.h"
#include "ui/document/job_permissions.h"
#include "ui/files/export_dialog.h"
#include "ui/files/outside_question.h"
#include "ui/files/run_to_end.h"
#include "ui/files/save_dialog.h"
#include "ui/files/save_question.h"
#include "ui/look/resource_paths.h"
#include "ui/look/typed_text.h"

namespace proveout {

namespace {

/// Common extensions of NC programs.
const QString kProgramPatterns =
    QStringLiteral("*.nc *.ngc *.cnc *.tap *.gcode *.iso *.min *.mpf *.eia *.txt");

} // namespace

FileFlow::FileFlow(Session& session, QWidget& window)
    : QObject(&window), m_session(session), m_window(window) {
    connect(&session.problems(), &ProblemsHub::troubled, this,
            [this] { m_closeAfterExport = m_closeAfterSave = false; });
    connect(&session.document().writer(), &DocumentWriter::ended, this, &FileFlow::closeAfterSave,
            Qt::QueuedConnection);
    connect(&session.document(), &DocumentHub::opened, &m_recent, &RecentFiles::add);
    // Queued, because the sender has not finished yet.
    connect(&session.document(), &DocumentHub::outsideFilesNamed, this, &FileFlow::askAboutOutside,
            Qt::QueuedConnection);
    connect(&session.exports(), &ExportHub::exported, this, [this] {
        if (std::exchange(m_closeAfterExport, false))
            emit closeWanted();
    });
}

QString FileFlow::startFolder() const {
    const QString file = m_session.document().jobFile().isEmpty()
                             ? toQString(m_session.document().text().path)
                             : m_session.document().jobFile();
    if (!file.isEmpty() && !isSample(file))
        return QFileInfo(file).absolutePath();
    for (const QString& recent : m_recent.files())
        if (!isSample(recent))
            return QFileInfo(recent).absolutePath();
    return QDir::homePath();
}

bool FileFlow::open(const QString& file) {
    if (!mayDiscard())
        return false;
    m_session.document().openFile(QFileInfo(file).absoluteFilePath());
    return true;
}

void FileFlow::askAboutOutside(const QString& job, const std::vector<std::filesystem::path>& files) {
    if (!mayReadOutside(m_window, job, files))
        return;
    allowOutside(job, files);
    m_session.document().openFile(job);
}

void FileFlow::openByDialog() {
    const QString file = QFileDialog::getOpenFileName(
        &m_window, tr("Open"), startFolder(),
        tr("NC programs and jobs (%1)").arg(kProgramPatterns + u' ' + formatPatterns(*findFormat("job"))) +
            QStringLiteral(";;") + tr("All files (*)"));
    if (!file.isEmpty())
        open(file);
}

void FileFlow::newFile() {
    if (!mayDiscard())
        return;
    m_session.document().newFile();
    emit newBegun();
}

bool FileFlow::settle(const std::function<std::optional<DiskConflict>()>& next) {
    while (const std::optional<DiskConflict> conflict = next()) {
        const SaveAnswer answer = askBeforeSave(m_window, *conflict);
        if (answer == SaveAnswer::cancel)
            return false;
        if (answer == SaveAnswer::overwrite) {
            m_session.document().acceptDisk(*conflict);
            continue;
        }
        if (!m_session.document().saveBeside(conflict->part))
            return false;
        const QString beside = conflict->part == FilePart::text ? toQString(m_session.document().text().path)
                                                                : m_session.document().jobFile();
        m_recent.add(beside);
        emit saved(tr("Saved as %1; the other version is still in %2.")
                       .arg(QFileInfo(beside).fileName(), QFileInfo(toQString(conflict->file)).fileName()));
    }
    return true;
}

/// The file may change again between the question and the write; the session then refuses to overwrite it.
bool FileFlow::saveFiles() {
    if (!settle([this] { return m_session.document().conflict(); }))
        return false;
    const bool text = m_session.document().text().modified;
    const bool job = m_session.document().jobModified();
    if (!m_session.document().save())
        return false;
    reportSaved(text, job && !m_session.document().jobModified());
    return true;
}

void FileFlow::reportSaved(bool text, bool job) {
    QStringList names;
    if (text)
        names << QFileInfo(toQString(m_session.document().text().path)).fileName();
    if (job)
        names << QFileInfo(m_session.document().jobFile()).fileName();
    if (names.isEmpty())
        return;
    QString message = tr("Saved %1").arg(names.join(QStringLiteral(", ")));
    if (m_session.document().jobModified())
        message += tr(". The setup has not been saved as a job.");
    emit saved(message);
}

/// Text typed in a field counts too, even if the field still has the focus.
void FileFlow::collectChanges() {
    if (QWidget* field = QApplication::focusWidget())
        finishTyping(*field);
    m_session.job().collectChanges();
}

bool FileFlow::save() {
    if (isSaving()) {
        m_saveAgain = true;
        return false;
    }
    m_saving = true;
    bool all = false;
    do {
        m_saveAgain = false;
        all = saveNow();
    } while (all && m_saveAgain && m_session.document().modified());
    m_saving = false;
    closeAfterSave();
    return all;
}

bool FileFlow::isSaving() const {
    return m_saving || m_session.document().writer().isRunning();
}

/// Queued, because the function that saves has not returned yet.
void FileFlow::closeAfterSave() {
    if (!isSaving() && std::exchange(m_closeAfterSave, false))
        QMetaObject::invokeMethod(this, &FileFlow::closeWanted, Qt::QueuedConnection);
}

bool FileFlow::saveNow() {
    collectChanges();
    const Document& document = m_session.document().text();
    if (document.path.empty() || (document.modified && isSample(toQString(document.path))))
        return saveAs();
    const bool needsJobFile =
        m_session.document().jobFile().isEmpty() || isSample(m_session.document().jobFile());
    if (!document.modified && m_session.document().modified() && needsJobFile)
        return saveJobAs(); // only the setup was changed, and it has no file yet
    return saveFiles();
}

bool FileFlow::saveAs() {
    m_session.document().writer().wait();
    QString proposal = toQString(m_session.document().text().path);
    if (proposal.isEmpty())
        proposal = QDir(startFolder()).filePath(QStringLiteral("program.nc"));
    else if (isSample(proposal))
        proposal = QDir(startFolder()).filePath(QFileInfo(proposal).fileName());
    const QString file = askWhereToSave(m_window, tr("Save NC Program As"), proposal, tr("All files (*)"));
    if (file.isEmpty() || !saveTextAs(file))
        return false;
    if (isSample(m_session.document().jobFile()))
        m_session.document().detachJob();
    m_recent.add(file);
    return true;
}

bool FileFlow::saveTextAs(const QString& file) {
    if (file == toQString(m_session.document().text().path)) {
        if (!settle([this] { return m_session.document().conflict(FilePart::text); }))
            return false;
        if (toQString(m_session.document().text().path) != file)
            return true; // both files were kept on disk
    }
    if (!m_session.document().saveAs(file))
        return false;
    reportSaved(true, false);
    return true;
}

bool FileFlow::saveJobAs() {
    m_session.document().writer().wait();
    if (m_session.document().text().path.empty() && !saveAs())
        return false; // a job must name its program
    QString proposal = m_session.document().jobFile();
    if (proposal.isEmpty() || isSample(proposal)) {
        const QFileInfo program(toQString(m_session.document().text().path));
        const QDir folder = isSample(program.filePath()) ? QDir(startFolder()) : program.dir();
        proposal = folder.filePath(program.completeBaseName() + QStringLiteral(".proveout"));
    }
    const QString file = askWhereToSave(m_window, tr("Save Job As"), proposal,
                                        formatFilter(*findFormat("job")), QStringLiteral("proveout"));
    if (file.isEmpty())
        return false;
    if (file == m_session.document().jobFile()) {
        if (!settle([this] { return m_session.document().conflict(FilePart::job); }))
            return false;
        if (m_session.document().jobFile() != file)
            return true; // both files were kept on disk
    }
    if (!m_session.document().saveJobAs(file))
        return false;
    m_recent.add(file);
    reportSaved(false, true);
    return true;
}

/// Adds the block of the stock if the program has not run to its end.
QString FileFlow::titled(const QString& title) const {
    const QString moment = momentText(m_session);
    return moment.isEmpty() ? title : title + QStringLiteral(" – ") + moment;
}

void FileFlow::saveStock() {
    if (!settleHalfRun(m_window, m_session))
        return;
    const QString program = QFileInfo(toQString(m_session.document().text().path)).completeBaseName();
    const QString stem = program.isEmpty() ? QStringLiteral("part") : program;
    const QString file = askWhereToSave(m_window, titled(tr("Save Stock")),
                                        QDir(startFolder()).filePath(stem + QStringLiteral(".pvstock")),
                                        formatFilter(*findFormat("stock")), QStringLiteral("pvstock"));
    if (!file.isEmpty() && mayReplaceStock(m_window, m_session.job().setup().shape, file))
        m_session.exports().saveStock(file);
}

void FileFlow::exportByDialog(bool decimated) {
    if (!settleHalfRun(m_window, m_session))
        return;
    const QString program = QFileInfo(toQString(m_session.document().text().path)).completeBaseName();
    const QString stem = program.isEmpty() ? QStringLiteral("part") : program;
    const auto target = askForExport(
        m_window, titled(decimated ? tr("Export Decimated Mesh") : tr("Export Full-Resolution Mesh")),
        QDir(startFolder()).filePath(stem));
    if (target && mayReplaceStock(m_window, m_session.job().setup().shape, target->file))
        m_session.exports().exportMesh(target->file, {decimated, target->format});
}

QString FileFlow::unsaved() const {
    QStringList sentences;
    const QString program = QFileInfo(toQString(m_session.document().text().path)).fileName();
    if (m_session.document().text().modified)
        sentences << (program.isEmpty() ? tr("The new program has not been saved.")
                                        : tr("%1 has unsaved changes.").arg(program));
    const QString job = QFileInfo(m_session.document().jobFile()).fileName();
    if (m_session.document().jobModified())
        sentences << (job.isEmpty() ? tr("The setup has not been saved as a job.")
                                    : tr("The setup of %1 has unsaved changes.").arg(job));
    return sentences.join(u'\n');
}

bool FileFlow::mayDiscard() {
    m_session.document().writer().wait();
    collectChanges();
    if (!m_session.document().modified())
        return true;
    QMessageBox question(QMessageBox::Warning, tr("Unsaved changes"), unsaved(),
                         QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &m_window);
    question.setTextFormat(Qt::PlainText); // the names come from the user
    question.setInformativeText(tr("Save the changes first?"));
    question.setDefaultButton(QMessageBox::Save);
    const int answer = question.exec();
    if (answer == QMessageBox::Save)
        return save() && !m_session.document().text().modified && // it may have been edited during the save
               (!m_session.document().modified() || saveJobAs());
    return answer == QMessageBox::Discard;
}

FileFlow::ExportAnswer FileFlow::askAboutExport() {
    QMessageBox question(QMessageBox::Warning, tr("Export in progress"), tr("A file is still being written."),
                         QMessageBox::Cancel, &m_window);
    question.setInformativeText(tr("Close after the file is written, or discard the file and close now?"));
    const QPushButton* wait = question.addButton(tr("&Wait for the File"), QMessageBox::AcceptRole);
    const QPushButton* drop = question.addButton(tr("&Discard the File"), QMessageBox::DestructiveRole);
    question.setDefaultButton(QMessageBox::Cancel);
    bool failed = false; // the export may fail while the question is open
    connect(&m_session.problems(), &ProblemsHub::troubled, &question, [&failed] { failed = true; });
    question.exec();
    if (question.clickedButton() == drop)
        return ExportAnswer::drop;
    if (question.clickedButton() != wait || failed)
        return ExportAnswer::stay;
    return m_session.exports().isRunning() ? ExportAnswer::wait : ExportAnswer::written;
}

bool FileFlow::mayClose() {
    m_closeAfterSave = isSaving();
    if (m_closeAfterSave)
        return false;
    m_closeAfterExport = false; // otherwise the end of the export would close the window while a question is
                                // open
    const ExportAnswer answer = m_session.exports().isRunning() ? askAboutExport() : ExportAnswer::written;
    m_closeAfterExport = answer == ExportAnswer::wait;
    if (answer == ExportAnswer::wait || answer == ExportAnswer::stay || !mayDiscard())
        return false;
    if (m_session.exports().isRunning())
        m_session.work().cancel();
    return true;
}

QString FileFlow::droppedFile(const QMimeData& data, QString& reason) {
    const QList<QUrl> urls = data.urls();
    if (urls.size() != 1 || !urls.front().isLocalFile()) {
        reason = tr("Drop a single file from this computer.");
        return {};
    }
    const QFileInfo file(urls.front().toLocalFile());
    if (file.isDir()) {
        reason = tr("A folder cannot be opened; drop an NC program or a job.");
        return {};
    }
    if (meshFormatOf(toPath(file.fileName()))) {
        reason = tr("A mesh is not a program. To cut it, choose it as the stock in the Setup panel.");
        return {};
    }
    return file.absoluteFilePath();
}

} // namespace proveout
