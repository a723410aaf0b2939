// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/file_flow.h"

#include <utility>

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QUrl>

#include "core/formats/formats.h"
#include "ui/export_dialog.h"
#include "ui/file_paths.h"
#include "ui/resource_paths.h"
#include "ui/save_dialog.h"

namespace proveout {

FileFlow::FileFlow(Session& session, QWidget& window)
    : QObject(&window), m_session(session), m_window(window) {
    connect(&session, &Session::troubled, this, [this] { m_closeAfterExport = false; });
    connect(&session, &Session::opened, &m_recent, &RecentFiles::add);
    connect(&session, &Session::exported, this, [this] {
        if (std::exchange(m_closeAfterExport, false))
            emit closeWanted();
    });
}

QString FileFlow::startFolder() const {
    const QString file =
        m_session.jobFile().isEmpty() ? toQString(m_session.document().path) : m_session.jobFile();
    if (!file.isEmpty() && !isSample(file))
        return QFileInfo(file).absolutePath();
    return m_recent.files().isEmpty() ? QDir::homePath() : QFileInfo(m_recent.files().front()).absolutePath();
}

bool FileFlow::open(const QString& file) {
    if (!mayDiscard())
        return false;
    m_session.openFile(QFileInfo(file).absoluteFilePath());
    return true;
}

void FileFlow::openByDialog() {
    const QString file = QFileDialog::getOpenFileName(
        &m_window, tr("Open"), startFolder(),
        tr("NC programs and jobs (*.nc *.ngc *.cnc *.tap *.gcode *.iso *.min *.mpf *.eia *.txt *.proveout)") +
            QStringLiteral(";;") + tr("All files (*)"));
    if (!file.isEmpty())
        open(file);
}

void FileFlow::newFile() {
    if (mayDiscard())
        m_session.newFile();
}

bool FileFlow::save() {
    const Document& document = m_session.document();
    if (document.path.empty() || (document.modified && isSample(toQString(document.path))))
        return saveAs();
    const bool needsJobFile = m_session.jobFile().isEmpty() || isSample(m_session.jobFile());
    if (!document.modified && m_session.modified() && needsJobFile)
        return saveJobAs(); // only the setup was changed, and it has no file of its own yet
    return m_session.save();
}

bool FileFlow::saveAs() {
    QString proposal = toQString(m_session.document().path);
    if (proposal.isEmpty())
        proposal = QDir(startFolder()).filePath(QStringLiteral("program.nc"));
    else if (isSample(proposal))
        proposal = QDir(startFolder()).filePath(QFileInfo(proposal).fileName());
    const QString file = askWhereToSave(m_window, tr("Save NC Program As"), proposal, tr("All files (*)"));
    if (file.isEmpty() || !m_session.saveAs(file))
        return false;
    if (isSample(m_session.jobFile()))
        m_session.detachJob();
    m_recent.add(file);
    return true;
}

bool FileFlow::saveJobAs() {
    if (m_session.document().path.empty() && !saveAs())
        return false; // a job names its program
    QString proposal = m_session.jobFile();
    if (proposal.isEmpty() || isSample(proposal)) {
        const QFileInfo program(toQString(m_session.document().path));
        const QDir folder = isSample(program.filePath()) ? QDir(startFolder()) : program.dir();
        proposal = folder.filePath(program.completeBaseName() + QStringLiteral(".proveout"));
    }
    const QString file = askWhereToSave(m_window, tr("Save Job As"), proposal,
                                        tr("Proveout jobs (*.proveout)"), QStringLiteral("proveout"));
    if (file.isEmpty() || !m_session.saveJobAs(file))
        return false;
    m_recent.add(file);
    return true;
}

void FileFlow::saveStock() {
    const QString program = QFileInfo(toQString(m_session.document().path)).completeBaseName();
    const QString stem = program.isEmpty() ? QStringLiteral("part") : program;
    const QString file = askWhereToSave(m_window, tr("Save Stock"),
                                        QDir(startFolder()).filePath(stem + QStringLiteral(".pvstock")),
                                        tr("Proveout stock (*.pvstock)"), QStringLiteral("pvstock"));
    if (!file.isEmpty())
        m_session.saveStock(file);
}

void FileFlow::exportByDialog(bool decimated) {
    const QString program = QFileInfo(toQString(m_session.document().path)).completeBaseName();
    const QString stem = program.isEmpty() ? QStringLiteral("part") : program;
    const auto target =
        askForExport(m_window, decimated ? tr("Export Decimated Mesh") : tr("Export Full-Resolution Mesh"),
                     QDir(startFolder()).filePath(stem));
    if (target)
        m_session.exportMesh(target->file, {decimated, target->format});
}

QString FileFlow::unsaved() const {
    QStringList sentences;
    const QString program = QFileInfo(toQString(m_session.document().path)).fileName();
    if (m_session.document().modified)
        sentences << (program.isEmpty() ? tr("The text of the new program is not saved.")
                                        : tr("The text of %1 is not saved.").arg(program));
    const QString job = QFileInfo(m_session.jobFile()).fileName();
    if (m_session.jobModified())
        sentences << (job.isEmpty() ? tr("Setup and parameters are in no job file yet.")
                                    : tr("The setup and parameters of %1 are not saved.").arg(job));
    return sentences.join(u'\n');
}

bool FileFlow::mayDiscard() {
    if (!m_session.modified())
        return true;
    QMessageBox question(QMessageBox::Warning, tr("Unsaved changes"), unsaved(),
                         QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &m_window);
    question.setTextFormat(Qt::PlainText); // the names are the user's
    question.setInformativeText(tr("Save before going on?"));
    question.setDefaultButton(QMessageBox::Save);
    const int answer = question.exec();
    if (answer == QMessageBox::Save)
        return save() && (!m_session.modified() || saveJobAs());
    return answer == QMessageBox::Discard;
}

FileFlow::ExportAnswer FileFlow::askAboutExport() {
    QMessageBox question(QMessageBox::Warning, tr("Export under way"),
                         tr("An export is still being written."), QMessageBox::Cancel, &m_window);
    question.setInformativeText(tr("Close when the file is written, or now, without it?"));
    const QPushButton* wait = question.addButton(tr("&Wait for the File"), QMessageBox::AcceptRole);
    const QPushButton* drop = question.addButton(tr("&Drop the Export"), QMessageBox::DestructiveRole);
    question.setDefaultButton(QMessageBox::Cancel);
    bool failed = false; // while the question was read
    connect(&m_session, &Session::troubled, &question, [&failed] { failed = true; });
    question.exec();
    if (question.clickedButton() == drop)
        return ExportAnswer::drop;
    if (question.clickedButton() != wait || failed)
        return ExportAnswer::stay;
    return m_session.exporting() ? ExportAnswer::wait : ExportAnswer::written;
}

bool FileFlow::mayClose() {
    m_closeAfterExport = false; // else its end would close the window while a question is open
    const ExportAnswer answer = m_session.exporting() ? askAboutExport() : ExportAnswer::written;
    m_closeAfterExport = answer == ExportAnswer::wait;
    if (answer == ExportAnswer::wait || answer == ExportAnswer::stay || !mayDiscard())
        return false;
    if (m_session.exporting())
        m_session.cancelWork();
    return true;
}

QString FileFlow::droppedFile(const QMimeData& data, QString& reason) {
    const QList<QUrl> urls = data.urls();
    if (urls.size() != 1 || !urls.front().isLocalFile()) {
        reason = tr("Drop one file of this computer.");
        return {};
    }
    const QFileInfo file(urls.front().toLocalFile());
    if (file.isDir()) {
        reason = tr("A folder cannot be opened; drop an NC program or a job.");
        return {};
    }
    if (meshFormatOf(toPath(file.fileName()))) {
        reason = tr("A mesh cannot be opened; drop an NC program or a job.");
        return {};
    }
    return file.absoluteFilePath();
}

} // namespace proveout
