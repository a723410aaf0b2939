// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <stop_token>
#include <vector>

#include <QObject>

#include "core/study/optimiser.h"
#include "ui/work/ui_queue.h"

class QThread;

namespace proveout {

/// Creates the renderer of a study; called on the UI thread, for use on `thread`.
using MakeDrawing = std::function<Result<std::unique_ptr<DrawCost>>(QThread* thread)>;

/// Runs one study at a time on its own thread. UI thread; signals are emitted there too.
class StudyRunner final : public QObject {
    Q_OBJECT

public:
    explicit StudyRunner(MakeDrawing makeDrawing, QObject* parent = nullptr);
    ~StudyRunner() override; ///< stops the study and waits for it

    /// Does nothing if a study is running.
    void sweep(StudyJob job, std::vector<StudyPoint> points);
    /// Chooses region size and period, then measures the choice and the given parameters alternately.
    void optimise(StudyJob job, const DecimationParameters& given);
    void cancel() { m_stop.request_stop(); }
    [[nodiscard]] bool busy() const { return m_thread != nullptr; }

signals:
    void progressed(double done);
    void ran(const std::shared_ptr<const StudyRun>& run);
    void rehearsed(const std::shared_ptr<const Rehearsal>& rehearsal);
    void measured(const Measured& chosen, const Measured& given);
    void failed(const Diagnostics& problems);
    void ended();

private:
    void start(std::function<Result<void>(DrawCost&, const WorkContext&)> work);
    [[nodiscard]] SweepOptions options(DrawCost& drawing, const StudyJob& job, int repeats) const;

    MakeDrawing m_makeDrawing;
    std::unique_ptr<DrawCost> m_drawing;
    UiQueue m_replies;
    QThread* m_thread = nullptr;
    std::stop_source m_stop;
};

} // namespace proveout
