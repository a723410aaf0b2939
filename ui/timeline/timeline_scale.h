// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <QWidget>

#include "core/base/diagnostic.h"
#include "ui/timeline/activity_strip.h"

namespace proveout {

struct MeaningColors;

/// A tick on the scale: something happened after `block` executed blocks.
struct TimelineMark {
    enum class Kind : std::uint8_t { toolChange, breakpoint, problem };
    std::size_t block = 0;
    Kind kind = Kind::problem;
    Severity severity = Severity::note; ///< of a problem
};

/// The range of all blocks with the play head; scrubbing moves the head. Knows blocks only, no session.
class TimelineScale final : public QWidget {
    Q_OBJECT

public:
    explicit TimelineScale(QWidget* parent = nullptr);

    void setBlockCount(std::size_t blocks);
    /// Moves the head; while the user drags it, it stays under the mouse.
    void setBlock(std::size_t block);
    void setMarks(std::vector<TimelineMark> marks);
    /// What the strip under the track shows; it outlives the scale, and who changes it calls update().
    void setActivity(const ActivityLog& log) { m_activity = &log; }
    /// The blocks that stand at one pixel of the strip. There are some.
    [[nodiscard]] ActivityStrip::Stretch stretchAt(double x) const;

    [[nodiscard]] std::size_t blockAt(double x) const;
    [[nodiscard]] double positionOf(std::size_t block) const;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    /// The user dragged or clicked the head to a place.
    void scrubbed(std::size_t block);
    /// Wheel: so many blocks on (negative: back).
    void stepped(std::ptrdiff_t blocks);
    /// What the tool tip says about a block is asked from who knows the program.
    void tipWanted(std::size_t block, QPoint globalPlace);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    void paintTrack(QPainter& painter) const;
    void paintStrip(QPainter& painter);
    void paintNumbers(QPainter& painter) const;
    [[nodiscard]] int stripColumns() const;
    void paintMarks(QPainter& painter) const;
    static void paintMark(QPainter& painter, const MeaningColors& colors, const TimelineMark& mark, double x);
    void paintHead(QPainter& painter) const;
    void scrub(double x);
    void moveHead(std::size_t block);

    std::size_t m_blocks = 0;
    std::size_t m_block = 0;
    bool m_dragging = false;
    int m_wheel = 0;                   ///< turned, not yet stepped, in eighths of a degree
    std::vector<TimelineMark> m_marks; ///< by kind, then severity, then block
    const ActivityLog* m_activity = nullptr;
    ActivityStrip m_strip;
};

} // namespace proveout
