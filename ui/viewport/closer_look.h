// SPDX-License-Identifier: GPL-3.0-or-later
// A box of interest in the 3D view: which one, what of it is there, and whether that is of the present block.
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

/// A box cut and decimated, as a frame of its own; what it was made for is told by its program, set-up and
/// block. Any thread. Nothing where it was stopped. Errors: those of fineGrid().
[[nodiscard]] Result<FramePtr> closerFrame(const Frame& frame, const BoxOfInterest& box,
                                           const WorkContext& context,
                                           double availableBytes = static_cast<double>(memoryLimitBytes()));

/// Cuts the box in the background, anew whenever the frame is another. Thread: UI.
class CloserLook : public QObject {
    Q_OBJECT

public:
    explicit CloserLook(QObject* parent = nullptr);

    /// Another box, or another spacing; it is kept until close().
    void look(const BoxOfInterest& box);
    void close();
    /// What the view shows now; null: nothing. A box of another block is not shown, and cut anew once the
    /// frame stays for a moment.
    void follow(const FramePtr& frame);
    /// Leaves what is under way; the box is not shown until something changes, or again().
    void cancel();
    /// Cuts a box that was left.
    void again();
    [[nodiscard]] bool isLeft() const {
        return m_box && m_frame && !m_working && m_refused.empty() && !isCurrent();
    }

    [[nodiscard]] const std::optional<BoxOfInterest>& box() const { return m_box; }
    /// Of the frame that is followed; null while there is none.
    [[nodiscard]] FramePtr picture() const { return isCurrent() ? m_fine : nullptr; }
    [[nodiscard]] bool working() const { return m_working; }
    [[nodiscard]] double done() const { return m_done; } ///< in [0, 1]
    /// How it stands, in words; translated.
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
    double m_seconds = 0; ///< that m_fine took
    Diagnostics m_refused;
    bool m_working = false; ///< under way, or soon
    double m_done = 0;
    QTimer m_pause;
    NewestTask m_task; ///< last: its thread ends before what it posts to
};

} // namespace proveout
