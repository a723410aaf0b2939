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

/// A mark on the scale after `block` executed blocks.
struct TimelineMark {
    enum class Kind : std::uint8_t { toolChange, breakpoint, problem };
    std::size_t block = 0;
    Kind kind = Kind::problem;
    Severity severity = Severity::note; ///< of a problem
};

/// The range of all blocks with a marker at the current block, which can be dragged. Knows only blocks, not
/// the session.
class TimelineScale final : public QWidget {
    Q_OBJECT

public:
    explicit TimelineScale(QWidget* parent = nullptr);

    void setBlockCount(std::size_t blocks);
    /// Moves the marker; while the user drags it, it stays under the mouse.
    void setBlock(std::size_t block);
    void setMarks(std::vector<TimelineMark> marks);
    /// The data of the strip below the track; it must outlive the scale, and callers that change it must call
    /// update().
    void setActivity(const ActivityLog& log) { m_activity = &log; }
    /// The blocks at a pixel of the strip; there must be blocks.
    [[nodiscard]] ActivityStrip::Stretch stretchAt(double x) const;

    [[nodiscard]] std::size_t blockAt(double x) const;
    [[nodiscard]] double positionOf(std::size_t block) const;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    /// The user dragged the marker to a block or clicked there.
    void scrubbed(std::size_t block);
    /// The wheel moved by this many blocks (negative: back).
    void stepped(std::ptrdiff_t blocks);
    /// Requests the tooltip for a block, because the scale does not know the program.
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
    int m_wheel = 0;                   ///< turned but not yet used for steps, in eighths of a degree
    std::vector<TimelineMark> m_marks; ///< by kind, then severity, then block
    const ActivityLog* m_activity = nullptr;
    ActivityStrip m_strip;
};

} // namespace proveout
