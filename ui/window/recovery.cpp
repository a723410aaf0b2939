// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/recovery.h"

#include <algorithm>
#include <utility>

#include <QDir>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>

#include "core/formats/job_file.h"
#include "ui/document/file_paths.h"
#include "ui/files/compare_dialog.h"
#include "ui/files/kept_breakpoints.h"
#include "ui/window/main_window.h"
#include "ui/window/recovery_bar.h"

namespace proveout {

namespace {

constexpr std::uint64_t kLargestCompared = 64'000'000; ///< bytes

QString nameOf(const KeptWork& work) {
    return work.program.empty() ? Recovery::tr("untitled") : QFileInfo(toQString(work.program)).fileName();
}

NcText onDisk(const std::filesystem::path& file) {
    return file.empty() ? NcText() : DiskCopy::read(file, kLargestCompared).value_or(DiskCopy()).text();
}

/// Compares the backups with the files.
std::vector<Comparison> comparisonsOf(const KeptWork& work, const JobDocument& document) {
    std::vector<Comparison> comparisons;
    const QString where = Recovery::tr("in the backup");
    if (!work.keptText.empty())
        comparisons.push_back({nameOf(work), onDisk(work.program), document.text().text, where});
    if (work.jobModified) {
        const std::filesystem::path file = work.jobFile.isEmpty() ? work.keptJob : toPath(work.jobFile);
        Job job = document.job();
        if (job.program.empty())
            job.program = work.keptText;
        comparisons.push_back(
            {work.jobFile.isEmpty() ? Recovery::tr("Setup") : QFileInfo(work.jobFile).fileName(),
             onDisk(toPath(work.jobFile)), NcText(jobText(file, job).value_or(std::string())), where});
    }
    return comparisons;
}

} // namespace

QString Recovery::defaultRoot() {
    return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation))
        .filePath(QStringLiteral("recovery"));
}

Recovery::Recovery(MainWindow& window, const QString& root)
    : m_window(window), m_bar(new RecoveryBar(&window)),
      m_autosave(window.session(), root, [&window] { return window.layout(); }) {
    window.addNotice(m_bar);
    connect(m_bar, &RecoveryBar::restoreWanted, this, &Recovery::restore);
    connect(m_bar, &RecoveryBar::compareWanted, this, &Recovery::compare);
    connect(m_bar, &RecoveryBar::discardWanted, this, &Recovery::discard);
    find(root);
}

/// The newest layout is adopted immediately, because that loses nothing.
void Recovery::find(const QString& root) {
    for (SessionFolder& folder : SessionFolder::abandoned(root)) {
        if (Result<KeptSession> session = readKeptSession(folder.path()))
            m_left.push_back({std::move(folder), std::move(*session)});
        else
            folder.remove();
    }
    std::ranges::sort(m_left, std::ranges::greater(), [](const Left& left) { return left.session.time; });
    if (!m_left.empty())
        m_window.setLayout(m_left.front().session.state.layout);
    std::erase_if(m_left, [](Left& left) {
        if (!left.session.isUnsaved())
            left.folder.remove();
        return !left.session.isUnsaved();
    });
    show();
}

void Recovery::show() {
    std::vector<RecoveryRow> rows;
    for (const Left& left : m_left) {
        const KeptWork& work = left.session.work;
        rows.push_back({left.folder.path(), toQString(work.program), !work.keptText.empty(), work.jobModified,
                        left.session.time});
    }
    m_bar->showRows(std::move(rows));
}

Recovery::Left* Recovery::leftIn(const QString& folder) {
    const auto found =
        std::ranges::find_if(m_left, [&](const Left& left) { return left.folder.path() == folder; });
    return found == m_left.end() ? nullptr : &*found;
}

void Recovery::restore(const QString& folder) {
    const Left* left = leftIn(folder);
    if (left == nullptr || !m_window.files().mayDiscard())
        return;
    m_window.session().document().restore(left->session.work, [this, folder, state = left->session.state] {
        m_window.session().breakpoints().set(KeptBreakpoints::read(state.breakpoints));
        const bool whole =
            std::ranges::none_of(m_window.session().document().job().warnings(),
                                 [](const Diagnostic& each) { return each.severity == Severity::error; });
        // The old folder is the only backup until this session has written its own.
        if (whole)
            m_autosave.keepNow([this, folder] { forget(folder); });
    });
}

void Recovery::compare(const QString& folder) {
    const Left* left = leftIn(folder);
    if (left == nullptr)
        return;
    const Result<JobDocument> document = JobDocument::restore(left->session.work);
    if (!document) {
        m_window.session().problems().report(document.error());
        return;
    }
    CompareDialog(comparisonsOf(left->session.work, *document), &m_window).exec();
}

void Recovery::discard(const QString& folder) {
    const Left* left = leftIn(folder);
    if (left == nullptr)
        return;
    QMessageBox question(QMessageBox::Warning, tr("Discard unsaved changes"),
                         tr("Discard the unsaved changes of %1?").arg(nameOf(left->session.work)),
                         QMessageBox::Discard | QMessageBox::Cancel, &m_window);
    question.setTextFormat(Qt::PlainText); // the name comes from the user
    question.setInformativeText(tr("The backup will be deleted. The file on disk is not changed."));
    question.setDefaultButton(QMessageBox::Cancel);
    if (question.exec() == QMessageBox::Discard)
        forget(folder);
}

void Recovery::forget(const QString& folder) {
    if (Left* left = leftIn(folder))
        left->folder.remove();
    std::erase_if(m_left, [&](const Left& left) { return left.folder.path() == folder; });
    show();
}

} // namespace proveout
