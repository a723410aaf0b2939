// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>

#include <QObject>
#include <QTimer>

#include "core/base/diagnostic.h"
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

/// The result of interpreting the text: the program, its cutting extent and its machine time. The text is
/// interpreted in the background whenever the user stops typing for a moment. Thread: the UI thread.
class ProgramHub final : public QObject {
    Q_OBJECT

public:
    /// All three must outlive this object.
    ProgramHub(const DocumentHub& document, ProblemsHub& problems, WorkHub& work);

    /// The newest interpretation; null before the first one. It may be newer than the program of the newest
    /// frame.
    [[nodiscard]] const std::shared_ptr<const Program>& current() const { return m_program; }
    [[nodiscard]] std::size_t blockCount() const { return m_program ? m_program->blockCount() : 0; }
    /// The machine time of current(); null until it is known.
    [[nodiscard]] const std::shared_ptr<const MachineTimes>& times() const { return m_times; }
    /// The cutting extent of current().
    [[nodiscard]] const CuttingExtent& cutting() const { return m_cutting; }
    /// The tools that comments of the text describe.
    [[nodiscard]] const ToolProposals& proposals() const { return m_proposals; }
    /// Whether the text is known not to be a supported program; then there are no frames of it.
    [[nodiscard]] bool isForeign() const { return m_program && m_program->foreignKind() != nullptr; }
    /// Whether current() is only the beginning of a program that is still being read.
    [[nodiscard]] bool isReading() const { return m_begun; }
    /// Whether current() belongs to the current text and setup.
    [[nodiscard]] bool isUpToDate() const { return m_upToDate; }

    /// Interprets the current text with the current setup.
    void interpret();
    /// Computes times() for the machine of the document.
    void measure();
    /// Clears the program because another document is open.
    void reset();

signals:
    void changed();
    void timesChanged();
    /// For the session: proposals() have changed; `before` is the previous value.
    void proposed(const ToolProposals& before);
    /// For the session, emitted before changed(). `whole`: false if the rest is still being read. `more`: the
    /// previous program was the beginning of this one.
    void arrived(bool whole, bool more);
    /// The text could not be interpreted; emitted instead of arrived() and changed().
    void failed(const Diagnostics& errors);
    /// Results about current() are void, because the text, the setup or the program has changed.
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
    QTimer m_editPause; ///< the text is interpreted after a short pause in typing
    ProgramSource m_source;
    NewestTask m_timing;
};

} // namespace proveout
