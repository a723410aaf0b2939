// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/files/run_to_end.h"

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLocale>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

namespace proveout {

namespace {

constexpr int kSteps = 1000;
constexpr int kWidth = 360;

QString text(const char* source) {
    return QCoreApplication::translate("RunToEnd", source);
}

QString number(const QLocale& locale, std::size_t value) {
    return locale.toString(static_cast<qulonglong>(value));
}

} // namespace

bool isHalfRun(const Session& session) {
    const FramePtr& frame = session.simulation().frame();
    return frame && (session.program().isReading() || frame->program != session.program().current() ||
                     frame->block < session.program().blockCount());
}

QString momentText(const Session& session) {
    if (!isHalfRun(session))
        return {};
    const QLocale locale;
    return text(QT_TRANSLATE_NOOP("RunToEnd", "stock after block %1 of %2"))
        .arg(number(locale, session.simulation().block()), number(locale, session.program().blockCount()));
}

bool settleHalfRun(QWidget& parent, Session& session) {
    if (!isHalfRun(session))
        return true;
    if (session.playback().state().playing)
        session.playback().pause(); // the question is about the current block
    const QLocale locale = parent.locale();
    QMessageBox question(QMessageBox::Question,
                         text(QT_TRANSLATE_NOOP("RunToEnd", "Program not run to the end")),
                         text(QT_TRANSLATE_NOOP("RunToEnd", "The simulation is at block %1 of %2."))
                             .arg(number(locale, session.simulation().block()),
                                  number(locale, session.program().blockCount())),
                         QMessageBox::Cancel, &parent);
    question.setInformativeText(text(
        QT_TRANSLATE_NOOP("RunToEnd", "Use the stock as it is now, or run the program to the end first?")));
    QPushButton* run = question.addButton(text(QT_TRANSLATE_NOOP("RunToEnd", "&Run to the End First")),
                                          QMessageBox::AcceptRole);
    const QPushButton* now =
        question.addButton(text(QT_TRANSLATE_NOOP("RunToEnd", "&Use Stock as Is")), QMessageBox::ActionRole);
    question.setDefaultButton(run);
    question.exec();
    if (question.clickedButton() == run)
        return RunToEnd(session, &parent).exec() == QDialog::Accepted;
    return question.clickedButton() == now;
}

RunToEnd::RunToEnd(Session& session, QWidget* parent)
    : QDialog(parent), m_session(session), m_progress(new QProgressBar(this)) {
    setWindowTitle(tr("Run to the End"));
    setMinimumWidth(kWidth);
    m_progress->setRange(0, kSteps);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &RunToEnd::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(new QLabel(tr("Running the program to the end…"), this));
    layout->addWidget(m_progress);
    layout->addWidget(buttons);
    connect(&session.playback(), &PlaybackHub::tick, this, &RunToEnd::look);
    connect(&session.program(), &ProgramHub::changed, this, &RunToEnd::look);
    connect(&session.work(), &WorkHub::changed, this, &RunToEnd::showProgress);
    connect(&session.problems(), &ProblemsHub::troubled, this, &QDialog::reject);
    // Queued, because a dialog can only be closed after it has opened.
    QMetaObject::invokeMethod(this, &RunToEnd::look, Qt::QueuedConnection);
}

void RunToEnd::look() {
    if (m_session.program().isReading() || !m_session.program().current())
        return;
    if (m_sought != m_session.program().current()) {
        m_sought = m_session.program().current();
        m_session.playback().seek(m_session.program().blockCount());
    }
    if (!isHalfRun(m_session))
        accept();
    showProgress();
}

void RunToEnd::showProgress() {
    if (m_session.work().current())
        m_progress->setValue(static_cast<int>(m_session.work().current()->done * kSteps));
}

void RunToEnd::reject() {
    m_session.work().cancel();
    QDialog::reject();
}

} // namespace proveout
