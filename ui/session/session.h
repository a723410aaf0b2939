// SPDX-License-Identifier: GPL-3.0-or-later
// The hubs of the workstation: panels talk to them, never to each other.
#pragma once

#include <QObject>

#include "ui/session/breakpoint_list.h"
#include "ui/session/check_hub.h"
#include "ui/session/contact_hub.h"
#include "ui/session/document_hub.h"
#include "ui/session/export_hub.h"
#include "ui/session/job_hub.h"
#include "ui/session/navigation_hub.h"
#include "ui/session/part_hub.h"
#include "ui/session/playback_hub.h"
#include "ui/session/problems_hub.h"
#include "ui/session/program_hub.h"
#include "ui/session/simulation_hub.h"
#include "ui/session/stock_file_hub.h"
#include "ui/session/work_hub.h"

namespace proveout {

/// One document with its program, playback and problems: owns the hubs and does what involves several of
/// them. Thread: the UI thread only; no call waits for work.
class Session final : public QObject {
    Q_OBJECT

public:
    explicit Session(QObject* parent = nullptr);

    [[nodiscard]] ProblemsHub& problems() { return m_problems; }
    [[nodiscard]] const ProblemsHub& problems() const { return m_problems; }
    [[nodiscard]] WorkHub& work() { return m_work; }
    [[nodiscard]] const WorkHub& work() const { return m_work; }
    [[nodiscard]] DocumentHub& document() { return m_document; }
    [[nodiscard]] const DocumentHub& document() const { return m_document; }
    [[nodiscard]] JobHub& job() { return m_job; }
    [[nodiscard]] const JobHub& job() const { return m_job; }
    [[nodiscard]] StockFileHub& stockFile() { return m_stockFile; }
    [[nodiscard]] ProgramHub& program() { return m_program; }
    [[nodiscard]] const ProgramHub& program() const { return m_program; }
    [[nodiscard]] SimulationHub& simulation() { return m_simulation; }
    [[nodiscard]] const SimulationHub& simulation() const { return m_simulation; }
    [[nodiscard]] BreakpointList& breakpoints() { return m_breakpoints; }
    [[nodiscard]] const BreakpointList& breakpoints() const { return m_breakpoints; }
    [[nodiscard]] PlaybackHub& playback() { return m_playback; }
    [[nodiscard]] const PlaybackHub& playback() const { return m_playback; }
    [[nodiscard]] NavigationHub& navigation() { return m_navigation; }
    [[nodiscard]] const NavigationHub& navigation() const { return m_navigation; }
    [[nodiscard]] PartHub& part() { return m_part; }
    [[nodiscard]] const PartHub& part() const { return m_part; }
    [[nodiscard]] CheckHub& check() { return m_check; }
    [[nodiscard]] const CheckHub& check() const { return m_check; }
    [[nodiscard]] ContactHub& contact() { return m_contact; }
    [[nodiscard]] const ContactHub& contact() const { return m_contact; }
    [[nodiscard]] ExportHub& exports() { return m_exports; }
    [[nodiscard]] const ExportHub& exports() const { return m_exports; }

private:
    void documentAdopted();
    void jobReread(const DecimationParameters& before);
    void programArrived(bool whole, bool more);

    // Each hub depends only on those before it.
    ProblemsHub m_problems;
    WorkHub m_work;
    DocumentHub m_document{m_problems, m_work};
    ProgramHub m_program{m_document, m_problems, m_work};
    SimulationHub m_simulation{m_document, m_program, m_problems, m_work};
    BreakpointList m_breakpoints{m_simulation};
    PlaybackHub m_playback{m_document, m_program, m_simulation, m_breakpoints};
    JobHub m_job{m_document, m_program, m_playback};
    StockFileHub m_stockFile{m_job, m_problems};
    NavigationHub m_navigation{{m_program, m_simulation, m_playback, m_problems, m_work}};
    PartHub m_part{m_job, m_simulation};
    CheckHub m_check{m_document, m_program, m_job, m_part};
    ContactHub m_contact{m_document, m_program, m_playback};
    ExportHub m_exports{{m_document, m_program, m_simulation, m_problems, m_work}};
};

} // namespace proveout
