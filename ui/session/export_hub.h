// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QObject>
#include <QString>

#include "ui/program/export_job.h"

namespace proveout {

class DocumentHub;
class ProblemsHub;
class ProgramHub;
class SimulationHub;
class WorkHub;

/// Writes the stock of the newest frame in the background. Thread: the UI thread.
class ExportHub final : public QObject {
    Q_OBJECT

public:
    /// The hubs that are queried; all must outlive this object.
    struct Hubs {
        const DocumentHub& document;
        const ProgramHub& program;
        SimulationHub& simulation;
        ProblemsHub& problems;
        WorkHub& work;
    };
    explicit ExportHub(const Hubs& hubs);

    /// The work hub reports the progress.
    void exportMesh(const QString& file, const ExportOptions& options);
    /// Saves the stock for the next setup.
    void saveStock(const QString& file);
    [[nodiscard]] bool isRunning() const { return m_running; }
    /// The result of the last export; empty before the first one.
    [[nodiscard]] const std::optional<ExportSummary>& last() const { return m_last; }

signals:
    void exported(const ExportSummary& summary);

private:
    /// Exports the frame that was taken last.
    void exportFrame(const QString& file, const ExportOptions& options);
    void finish(const Result<ExportSummary>& result);

    Hubs m_hubs;
    bool m_running = false;
    std::optional<ExportSummary> m_last;
    ExportJob m_export;
};

} // namespace proveout
