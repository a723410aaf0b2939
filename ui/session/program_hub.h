// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>

#include <QObject>
#include <QTimer>

#include "core/nc/program/program.h"
#include "core/simulation/setup/tool_proposals.h"
#include "core/simulation/time/machine_time.h"
#include "ui/program/program_index.h"
#include "ui/program/program_source.h"
#include "ui/work/newest_task.h"

namespace proveout {

class DocumentHub;
class ProblemsHub;
class WorkHub;

/// What the text of the document says: the program, its cutting extent and its machine time. Interpreted in
/// the background after every rest in typing. Thread: the UI thread.
class ProgramHub final : public QObject {
    Q_OBJECT

public:
    /// All three outlive it.
    ProgramHub(const DocumentHub& document, ProblemsHub& problems, WorkHub& work);

    /// The newest interpretation; null before the first one. May be ahead of the program of the newest frame.
    [[nodiscard]] const std::shared_ptr<const Program>& current() const { return m_program; }
    [[nodiscard]] std::size_t blockCount() const { return m_program ? m_program->blockCount() : 0; }
    /// How long the machine takes for current(); null while that is not known yet.
    [[nodiscard]] const std::shared_ptr<const MachineTimes>& times() const { return m_times; }
    /// What current() cuts.
    [[nodiscard]] const CuttingExtent& cutting() const { return m_cutting; }
    /// The tools that the comments of the text describe.
    [[nodiscard]] const ToolProposals& proposals() const { return m_proposals; }
    /// Whether the text is known to be no program of ours: there is no frame of it.
    [[nodiscard]] bool isForeign() const { return m_program && m_program->foreignKind() != nullptr; }
    /// Whether current() is only the beginning of one whose rest is still being read.
    [[nodiscard]] bool isReading() const { return m_begun; }
    /// Whether current() is that of the text and the setup as they are now.
    [[nodiscard]] bool isUpToDate() const { return m_upToDate; }

    /// Interprets the text with the setup as they are now.
    void interpret();
    /// Computes times() for the machine of the document.
    void measure();
    /// Another document: there is no program of it yet.
    void reset();

signals:
    void changed();
    void timesChanged();
    /// For the session: proposals() are new, those before are given.
    void proposed(const ToolProposals& before);
    /// For the session, before changed(). `whole`: else the rest is still being read. `more`: the program
    /// before was the beginning of this one.
    void arrived(bool whole, bool more);
    /// Answers about current() are void: the text, the setup or the program is another.
    void outdated();

private:
    void markOutdated();
    void adopt(const std::shared_ptr<const Program>& program, const CuttingExtent& cutting, bool whole);
    void measured(const std::shared_ptr<const MachineTimes>& times);

    const DocumentHub& m_document;
    ProblemsHub& m_problems;
    WorkHub& m_work;
    std::shared_ptr<const Program> m_program;
    CuttingExtent m_cutting;
    ToolProposals m_proposals;
    std::shared_ptr<const MachineTimes> m_times; ///< of m_program, or null
    bool m_begun = false;
    bool m_upToDate = false;
    QTimer m_editPause; ///< typing is interpreted after a short rest
    ProgramSource m_source;
    NewestTask m_timing;
};

} // namespace proveout
