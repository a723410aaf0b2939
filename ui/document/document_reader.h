// SPDX-License-Identifier: GPL-3.0-or-later
// Reading documents in the background.
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

/// Reads one document at a time on its own thread; a new request takes the place of the one before, of which
/// nothing is told any more. Thread: the UI thread, which also gets results and signals. What is read belongs
/// to the thread until it is handed over whole; the open document is not touched.
class DocumentReader : public QObject {
    Q_OBJECT

public:
    template<typename T>
    using Done = std::function<void(Result<T>)>;

    explicit DocumentReader(QObject* parent = nullptr);

    /// As JobDocument::open(), with the files outside the folder of a job that the user has allowed
    /// (job_permissions.h); what the reading throws is told as an error too.
    void open(const QString& file, Done<JobDocument> done);
    /// As JobDocument::restore().
    void restore(const KeptWork& kept, Done<JobDocument> done);
    /// As JobDocument::readText().
    void readText(const std::filesystem::path& file, Done<Document> done);
    /// Forgets what is under way.
    void cancel();
    /// Until `done` is called or nobody wants to know any more.
    [[nodiscard]] bool isReading() const { return m_reading; }
    /// How far, in [0, 1]; empty where nothing is read, or a short file not yet for long.
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
