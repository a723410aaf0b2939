// SPDX-License-Identifier: GPL-3.0-or-later
// Writes documents in the background.
#pragma once

#include <exception>
#include <functional>
#include <optional>
#include <thread>

#include <QEventLoop>
#include <QObject>
#include <QTimer>

#include "core/base/diagnostic.h"
#include "ui/document/file_watch.h"
#include "ui/document/job_document.h"
#include "ui/work/ui_queue.h"

namespace proveout {

/// Saves a document, and compares it with its files. With a long text a copy of it is saved on another thread
/// while the window handles its events: the document may be changed meanwhile, but not saved again. Thread:
/// UI, except `Save`. An exception during saving is thrown again.
class DocumentWriter final : public QObject {
    Q_OBJECT

public:
    /// One of the methods of a document that save it; on any thread.
    using Save = std::function<Result<void>(JobDocument& document)>;
    struct Written {
        Result<void> result;
        bool text = false; ///< whether it is in its file
        bool job = false;  ///< whether setup and parameters are
        bool open = true;  ///< false: another document has been opened meanwhile
    };

    explicit DocumentWriter(QObject* parent = nullptr);
    /// Waits for the save in progress; nothing is reported.
    ~DocumentWriter() override;

    /// Returns after `done`; nothing happens while a save is in progress. `part`: the one that is written
    /// whether or not it has changes; otherwise both, where they have. What is changed meanwhile is not in
    /// the file, and counts as unsaved.
    void save(JobDocument& document, const Save& save, std::optional<FilePart> part,
              const std::function<void(const Written&)>& done);
    /// JobDocument::conflict(). The window gets no input meanwhile: a question may follow.
    [[nodiscard]] std::optional<DiskConflict> conflict(const JobDocument& document, FilePart part);
    /// JobDocument's method of that name, for a new file beside the current one, which stays unchanged; from
    /// then on the part belongs to the new file. Errors: those of AtomicFile and writeJob().
    [[nodiscard]] static Result<void> saveBeside(JobDocument& document, FilePart part);
    /// Another document replaces the one that is being saved.
    void otherOpened() { m_open = false; }
    /// Waits for the save in progress; the window is painted meanwhile, but gets no input.
    void wait();
    [[nodiscard]] bool isRunning() const { return m_running; }
    /// Pauses the watch of a file while a save is in progress, which is not a change by another program. It
    /// must live as long as this object.
    void pause(FileWatch& watch);

signals:
    void started();
    /// In [0, 1], of a save that takes so long that the user should know; empty if there is none.
    void progressed(std::optional<double> done);
    /// After `done`.
    void ended();

private:
    /// Returns when `done` has been called on this thread, after `work` has ended on another one.
    void run(const std::function<void()>& work, const std::function<void()>& done,
             QEventLoop::ProcessEventsFlags meanwhile);
    void end();

    bool m_running = false;
    bool m_open = true;
    QTimer m_untilSlow;
    std::function<void()> m_done;
    std::exception_ptr m_exception;
    UiQueue m_replies;
    std::jthread m_thread;
};

} // namespace proveout
