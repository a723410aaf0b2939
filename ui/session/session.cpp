// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/session.h"

namespace proveout {

Session::Session(QObject* parent) : QObject(parent) {
    connect(&m_document, &DocumentHub::adopted, this, &Session::documentAdopted);
    connect(&m_document, &DocumentHub::jobReread, this, &Session::jobReread);
    connect(&m_program, &ProgramHub::proposed, &m_job, &JobHub::adoptProposals);
    connect(&m_program, &ProgramHub::arrived, this, &Session::programArrived);
}

/// Clears everything of the previous document before reporting the new one.
void Session::documentAdopted() {
    m_playback.reset();
    m_job.history().clear();
    m_program.reset();
    m_navigation.forgetJumps();
    m_problems.set(ProblemSource::files, {});
    m_document.watchFiles();
    emit m_job.replaced();
    emit m_document.textReplaced();
    emit m_document.changed();
    emit m_job.setupChanged();
    emit m_job.machineChanged();
    emit m_job.checkChanged();
    emit m_job.partChanged();
    emit m_program.timesChanged();
    emit m_job.parametersChanged();
    emit m_playback.changed();
    emit m_program.changed();
    m_problems.refresh();
    m_playback.requestTick();
}

void Session::jobReread(const DecimationParameters& before) {
    m_job.history().clear();
    emit m_job.replaced();
    m_program.interpret();
    m_job.reportSetup(before);
    emit m_job.machineChanged();
    emit m_job.checkChanged();
    emit m_job.partChanged();
    m_program.measure();
}

void Session::programArrived(bool whole, bool more) {
    if (m_document.job().wantsStock()) {
        m_job.fitStock(!whole);
        if (whole && m_program.current()->asksForStock())
            return m_program.interpret(); // the probing depends on the stock, which has now been fitted
    }
    m_job.fitGrid();
    if (!more)
        m_navigation.forgetJumps();
    m_program.measure();
    m_playback.simulate(more);
    emit m_program.changed();
    m_problems.refresh();
    m_playback.requestTick();
}

} // namespace proveout
