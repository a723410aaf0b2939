// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/timeline/timeline_scale.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include <QHelpEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>

#include "ui/look/theme.h"
#include "ui/look/wheel_focus.h"

namespace proveout {

namespace {

constexpr double kMargin = 10;  // half the width of the current block marker
constexpr double kTrackTop = 9; // the marks are above
constexpr double kTrackHeight = 10;
constexpr double kStripTop = 24; // below the current block marker
constexpr double kStripHeight = 8;
constexpr double kStripBottom = kStripTop + kStripHeight; // the numbers are below
constexpr double kHeadWidth = 11;
constexpr int kHeight = 54;
constexpr int kLabelEveryPixels = 90;
constexpr std::ptrdiff_t kFastFactor = 5;

/// The smallest step of the series 1, 2, 5 that is at least `wanted`.
std::size_t roundStep(double wanted) {
    const double decade = std::pow(10.0, std::floor(std::log10(std::max(1.0, wanted))));
    for (const double step : {1.0, 2.0, 5.0}) {
        if (step * decade >= wanted)
            return static_cast<std::size_t>(step * decade);
    }
    return static_cast<std::size_t>(10 * decade);
}

} // namespace

TimelineScale::TimelineScale(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    WheelFocus::mark(*this);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setCursor(Qt::PointingHandCursor);
}

QSize TimelineScale::sizeHint() const {
    return {400, kHeight};
}

QSize TimelineScale::minimumSizeHint() const {
    return {120, kHeight};
}

void TimelineScale::setBlockCount(std::size_t blocks) {
    if (blocks == m_blocks)
        return;
    m_blocks = blocks;
    m_block = std::min(m_block, blocks);
    update();
}

void TimelineScale::setBlock(std::size_t block) {
    if (!m_dragging)
        moveHead(block);
}

void TimelineScale::moveHead(std::size_t block) {
    block = std::min(block, m_blocks);
    if (block == m_block)
        return;
    m_block = block;
    update();
}

void TimelineScale::setMarks(std::vector<TimelineMark> marks) {
    m_marks = std::move(marks);
    // More severe marks are painted later, over the others.
    std::ranges::sort(m_marks, {}, [](const TimelineMark& mark) {
        return std::tuple(mark.kind, mark.severity, mark.block);
    });
    update();
}

double TimelineScale::positionOf(std::size_t block) const {
    const double length = width() - 2 * kMargin;
    return m_blocks == 0 ? kMargin
                         : kMargin + length * static_cast<double>(block) / static_cast<double>(m_blocks);
}

std::size_t TimelineScale::blockAt(double x) const {
    const double length = std::max(1.0, width() - 2 * kMargin);
    const double fraction = std::clamp((x - kMargin) / length, 0.0, 1.0);
    return static_cast<std::size_t>(std::lround(fraction * static_cast<double>(m_blocks)));
}

void TimelineScale::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintTrack(painter);
    paintStrip(painter);
    paintNumbers(painter);
    paintMarks(painter);
    paintHead(painter);
}

int TimelineScale::stripColumns() const {
    return std::max(1, static_cast<int>(std::lround((width() - 2 * kMargin) * devicePixelRatioF())));
}

ActivityStrip::Stretch TimelineScale::stretchAt(double x) const {
    const int columns = stripColumns();
    const auto column = static_cast<int>(std::floor((x - kMargin) * devicePixelRatioF()));
    return ActivityStrip::blocksOf(std::clamp(column, 0, columns - 1), columns, m_blocks);
}

void TimelineScale::paintTrack(QPainter& painter) const {
    const QRectF track(kMargin, kTrackTop, width() - 2 * kMargin, kTrackHeight);
    QRectF done = track;
    done.setRight(positionOf(m_block));
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::Mid));
    painter.drawRoundedRect(track, 3, 3);
    painter.setBrush(meaningColors(palette()).accent);
    painter.drawRoundedRect(done, 3, 3);
}

void TimelineScale::paintStrip(QPainter& painter) {
    if (m_blocks == 0 || m_activity == nullptr)
        return;
    const QRectF place(kMargin, kStripTop, width() - 2 * kMargin, kStripHeight);
    painter.setPen(QPen(palette().color(QPalette::Mid), 1));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRect(place.adjusted(-0.5, -0.5, 0.5, 0.5));
    const auto rows = static_cast<int>(std::lround(kStripHeight * devicePixelRatioF()));
    m_strip.fit({stripColumns(), rows}, m_blocks, ActivityStrip::colors(palette()));
    m_strip.update(*m_activity);
    painter.drawImage(place, m_strip.image());
}

void TimelineScale::paintNumbers(QPainter& painter) const {
    if (m_blocks == 0)
        return;
    QFont small = font();
    small.setPointSizeF(small.pointSizeF() * 0.85);
    painter.setFont(small);
    painter.setPen(palette().color(QPalette::PlaceholderText));
    const double labels = std::max(1.0, (width() - 2 * kMargin) / kLabelEveryPixels);
    const std::size_t step = roundStep(static_cast<double>(m_blocks) / labels);
    for (std::size_t block = 0; block <= m_blocks; block += step) {
        const double x = positionOf(block);
        painter.drawLine(QPointF(x, kStripBottom + 1), QPointF(x, kStripBottom + 4));
        const QString text = locale().toString(static_cast<qulonglong>(block));
        const double textWidth = painter.fontMetrics().horizontalAdvance(text);
        const double left = std::clamp(x - textWidth / 2, 0.0, std::max(0.0, width() - textWidth));
        painter.drawText(QPointF(left, kStripBottom + 5 + painter.fontMetrics().ascent()), text);
    }
}

void TimelineScale::paintMarks(QPainter& painter) const {
    const MeaningColors colors = meaningColors(palette());
    painter.setPen(Qt::NoPen);
    const TimelineMark* last = nullptr;
    for (const TimelineMark& mark : m_marks) {
        const double x = positionOf(mark.block);
        const bool alike = last != nullptr && last->kind == mark.kind && last->severity == mark.severity;
        if (alike && x - positionOf(last->block) < 1)
            continue; // thousands of marks on one pixel are drawn once
        last = &mark;
        paintMark(painter, colors, mark, x);
    }
}

/// The kinds also differ in shape: a triangle, a disc, a diamond.
void TimelineScale::paintMark(QPainter& painter, const MeaningColors& colors, const TimelineMark& mark,
                              double x) {
    QPolygonF shape;
    switch (mark.kind) {
    case TimelineMark::Kind::toolChange:
        painter.setBrush(colors.toolChange);
        shape << QPointF(x - 4, 1) << QPointF(x + 4, 1) << QPointF(x, 8);
        break;
    case TimelineMark::Kind::breakpoint:
        painter.setBrush(colors.breakpoint);
        painter.drawEllipse(QPointF(x, 4.5), 3.5, 3.5);
        return;
    case TimelineMark::Kind::problem:
        painter.setBrush(severityColor(colors, mark.severity));
        shape << QPointF(x, 0) << QPointF(x + 3.5, 4) << QPointF(x, 8) << QPointF(x - 3.5, 4);
        break;
    }
    painter.drawPolygon(shape);
}

void TimelineScale::paintHead(QPainter& painter) const {
    const double x = positionOf(m_block);
    const QRectF head(x - kHeadWidth / 2, kTrackTop - 3, kHeadWidth, kTrackHeight + 6);
    const bool focused = hasFocus();
    painter.setPen(QPen(meaningColors(palette()).accent, focused ? 2.5 : 1.5));
    painter.drawLine(QPointF(x, head.bottom()), QPointF(x, kStripBottom + 1));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRoundedRect(head, 3, 3);
}

bool TimelineScale::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        emit tipWanted(blockAt(help->pos().x()), help->globalPos());
        return true;
    }
    return QWidget::event(event);
}

void TimelineScale::scrub(double x) {
    const std::size_t block = blockAt(x);
    moveHead(block);
    emit scrubbed(block);
}

void TimelineScale::mousePressEvent(QMouseEvent* event) {
    m_dragging = event->button() == Qt::LeftButton && m_blocks > 0;
    if (m_dragging)
        scrub(event->position().x());
}

void TimelineScale::mouseMoveEvent(QMouseEvent* event) {
    if (m_dragging)
        scrub(event->position().x());
}

void TimelineScale::mouseReleaseEvent(QMouseEvent*) {
    m_dragging = false;
}

void TimelineScale::wheelEvent(QWheelEvent* event) {
    m_wheel -= event->angleDelta().y() + event->angleDelta().x(); // touchpads report fractions of a notch
    const std::ptrdiff_t notches = m_wheel / QWheelEvent::DefaultDeltasPerStep;
    m_wheel %= QWheelEvent::DefaultDeltasPerStep;
    const bool fast = (event->modifiers() & (Qt::ShiftModifier | Qt::ControlModifier)) != 0;
    if (notches != 0)
        emit stepped(fast ? notches * kFastFactor : notches);
    event->accept();
}

} // namespace proveout
