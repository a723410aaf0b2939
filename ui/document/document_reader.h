// SPDX-License-Identifier: GPL-3.0-or-later
// Reads documents in the background.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include <QObject>
#include <QString>
#include <QTimer>

#include "core/base/diagnostic.h"
#include "core/base/work_context.h"
#include "ui/document/document.h"
#include "ui/document/job_document.h"
#include "ui/work/newest_task.h"

namespace proveout {

/// Reads one document at a time on its own thread. A new request replaces the previous one, of which nothing
/// is reported after that. Thread: the UI thread, which also receives results and signals. A document belongs
/// to the reading thread until it is handed over complete; the open document is not touched.
class DocumentReader : public QObject {
    Q_OBJECT

public:
    template<typename T>
    using Done = std::function<void(Result<T>)>;

    explicit DocumentReader(QObject* parent = nullptr);

    /// Like JobDocument::open(), with the files outside the job's folder that the user has allowed
    /// (job_permissions.h). An exception during reading is reported as an error too.
    void open(const QString& file, Done<JobDocument> done);
    /// Like JobDocument::restore().
    void restore(const KeptWork& kept, Done<JobDocument> done);
    /// Like loadClosedDocument().
    void readText(const std::filesystem::path& file, Done<Document> done);
    /// Discards the request in progress.
    void cancel();
    /// True until `done` is called or the request is cancelled.
    [[nodiscard]] bool isReading() const { return m_reading; }
    /// Progress in [0, 1]; empty if nothing is being read, or if the reading has only just started.
    [[nodiscard]] const std::optional<double>& progress() const { return m_progress; }

signals:
    void progressChanged();

private:
    template<typename T>
    void start(std::function<Result<T>(const WorkContext&)> read, Done<T> done);
    void progressed(double done);
    void end();

    bool m_reading = false;
    std::optional<double> m_progress;
    QTimer m_untilReported;
    NewestTask m_task;
};

} // namespace proveout
