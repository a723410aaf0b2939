// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include <QObject>
#include <QTimer>

#include "core/base/diagnostic.h"
#include "core/verification/check/check_report.h"
#include "ui/work/newest_task.h"

namespace proveout {

class Checker;
class DocumentHub;
class JobHub;
class PartHub;
class ProgramHub;

/// The verdict on the open program. The whole program is checked in the background, on one thread of low
/// priority, whenever program, setup, machine and part have not changed for a moment; a change, another
/// document and the end of the session cancel it. Thread: the UI thread.
class CheckHub final : public QObject {
    Q_OBJECT

public:
    /// All must outlive this object.
    CheckHub(const DocumentHub& document, const ProgramHub& program, const JobHub& job, const PartHub& part);

    /// The result; null until it is known, and if there is none.
    [[nodiscard]] const std::shared_ptr<const CheckReport>& report() const { return m_report; }
    /// Why there is no result; empty if that is not known yet, or no program is open.
    [[nodiscard]] const Diagnostics& refusal() const { return m_refusal; }
    /// In [0, 1] while a result is awaited.
    [[nodiscard]] const std::optional<double>& progress() const { return m_progress; }

    /// The result before the last change of the same text; null if there was none.
    [[nodiscard]] const std::shared_ptr<const CheckReport>& before() const { return m_before; }
    /// How report() differs from it; nothing without both.
    [[nodiscard]] std::optional<CheckChange> change() const;

    /// Ids of what need not be checked (notCheckedRows()) in any program, besides those of the job; the
    /// result follows at once.
    void setAccepted(std::set<std::string> accepted);
    [[nodiscard]] const std::set<std::string>& accepted() const { return m_accepted; }
    /// Bytes that a check may allocate, instead of half of memoryLimitBytes(): the simulation needs the rest.
    void setMemoryLimit(std::uint64_t bytes);
    /// Whether programs are checked; initially they are.
    void setOn(bool on);

signals:
    /// report() or refusal() has changed, or a check has begun.
    void changed();
    /// progress() has risen by a per cent or more.
    void progressed();

private:
    void restart();
    void adoptRules();
    void answer();
    [[nodiscard]] IdsWithReasons allAccepted() const;
    void begin();
    void finish(const Result<std::shared_ptr<const CheckReport>>& result);

    const DocumentHub& m_document;
    const ProgramHub& m_program;
    const JobHub& m_job;
    const PartHub& m_part;
    std::shared_ptr<const CheckReport> m_report;
    std::shared_ptr<const CheckReport> m_before; ///< of the same text before it was edited
    Diagnostics m_refusal;
    std::optional<double> m_progress;
    std::set<std::string> m_accepted;
    CheckRules m_rules; ///< of the last or the running check
    std::optional<std::uint64_t> m_memoryLimit;
    bool m_on = true;
    QTimer m_pause;                     ///< between the last change and the check
    std::shared_ptr<Checker> m_checker; ///< used by the tasks, which run one after another
    NewestTask m_task;
};

} // namespace proveout
