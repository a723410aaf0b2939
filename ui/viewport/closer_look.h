// SPDX-License-Identifier: GPL-3.0-or-later
// A detail region in the 3D view: its extent, what has been cut of it, and whether that belongs to the
// current block.
#pragma once

#include <memory>
#include <optional>

#include <QObject>
#include <QString>
#include <QTimer>

#include "core/base/memory.h"
#include "core/simulation/records/box_of_interest.h"
#include "core/simulation/run/frame.h"
#include "ui/work/newest_task.h"

namespace proveout {

/// A detail region, cut and decimated, as a frame of its own; its program, setup and block identify what it
/// was computed for. Any thread. Null if it was stopped. Errors: those of fineGrid().
[[nodiscard]] Result<FramePtr> closerFrame(const Frame& frame, const BoxOfInterest& box,
                                           const WorkContext& context,
                                           double availableBytes = static_cast<double>(memoryLimitBytes()));

/// Cuts the detail region in the background, and again whenever the frame changes. Thread: UI.
class CloserLook : public QObject {
    Q_OBJECT

public:
    explicit CloserLook(QObject* parent = nullptr);

    /// Sets another box or another spacing; it is kept until close().
    void look(const BoxOfInterest& box);
    void close();
    /// Sets the frame in the view; null: none. A region of another block is hidden, and cut again once the
    /// frame stays the same for a moment.
    void follow(const FramePtr& frame);
    /// Cancels the cutting; the region is hidden until something changes or again() is called.
    void cancel();
    /// Cuts a region that was cancelled.
    void again();
    [[nodiscard]] bool isLeft() const {
        return m_box && m_frame && !m_working && m_refused.empty() && !isCurrent();
    }

    [[nodiscard]] const std::optional<BoxOfInterest>& box() const { return m_box; }
    /// The region for the current frame; null while there is none.
    [[nodiscard]] FramePtr picture() const { return isCurrent() ? m_fine : nullptr; }
    [[nodiscard]] bool working() const { return m_working; }
    [[nodiscard]] double done() const { return m_done; } ///< in [0, 1]
    /// The state in words; translated.
    [[nodiscard]] QString status() const;

signals:
    void changed();

private:
    [[nodiscard]] bool isCurrent() const;
    void cutSoon(int milliseconds);
    void cut();
    void finished(const Result<FramePtr>& result, double seconds);

    std::optional<BoxOfInterest> m_box;
    FramePtr m_frame;
    FramePtr m_fine;
    double m_seconds = 0; ///< duration of cutting m_fine
    Diagnostics m_refused;
    bool m_working = false; ///< running or about to start
    double m_done = 0;
    QTimer m_pause;
    NewestTask m_task; ///< last member: its thread must end before what it posts to is destroyed
};

} // namespace proveout
