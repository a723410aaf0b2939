// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/setup/tool_drawing.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include <QEvent>
#include <QLocale>
#include <QPainter>
#include <QPolygonF>

namespace proveout {

namespace {

constexpr int kHeight = 170; ///< px
constexpr int kLeastWidth = 120;
constexpr double kMargin = 8;
constexpr double kTick = 4;  ///< half the end of a dimension line
constexpr int kSamples = 24; ///< of a curved piece

/// Half of an outline, from the axis outwards and up; x: radius, y: height above the tip, mm.
using HalfOutline = QPolygonF;

void addPiece(HalfOutline& outline, const ProfilePiece& piece, bool inwards) {
    const double from = inwards ? piece.r1 : piece.r0;
    const double to = inwards ? piece.r0 : piece.r1;
    const int samples = piece.kind == PieceKind::line ? 1 : kSamples;
    for (int k = 0; k <= samples; ++k) {
        const double r = from + (to - from) * k / samples;
        const double z = piece.r0 == piece.r1 ? (k == 0 ? piece.z0 : piece.z1) : heightOf(piece, r);
        outline << QPointF(r, z);
    }
}

HalfOutline cuttingPart(const Cutter& cutter) {
    HalfOutline outline{{0, 0}};
    for (const ProfilePiece& piece : cutter.pieces())
        addPiece(outline, piece, false);
    const double top = cutter.fluteLength();
    if (const auto& head = cutter.head()) {
        for (std::size_t k = head->back.size(); k > 0; --k)
            addPiece(outline, head->back[k - 1], true);
        outline << QPointF(head->neckRadius, top);
    } else {
        outline << QPointF(cutter.radius(), top);
    }
    return outline << QPointF(0, top);
}

HalfOutline cylinder(double radius, double from, double to) {
    return {{0, from}, {radius, from}, {radius, to}, {0, to}};
}

/// Up to the holder or, without one, as long as it is said to be; else a stump.
HalfOutline shank(const Cutter& cutter) {
    const ToolBody& body = cutter.body();
    const double from = cutter.fluteLength();
    const double given = body.shankLength > 0 ? from + body.shankLength : from + 2 * body.shankRadius;
    return cylinder(body.shankRadius, from, body.holder.empty() ? given : std::max(from, body.stickOut));
}

HalfOutline holder(const Cutter& cutter) {
    HalfOutline outline;
    double z = cutter.body().stickOut;
    for (const HolderSegment& segment : cutter.body().holder) {
        if (outline.isEmpty())
            outline << QPointF(0, z);
        outline << QPointF(segment.lowerRadius, z) << QPointF(segment.upperRadius, z + segment.height);
        z += segment.height;
    }
    if (!outline.isEmpty())
        outline << QPointF(0, z);
    return outline;
}

/// Draws in mm of a tool whose axis is in the middle.
class Sheet {
public:
    Sheet(QPainter& painter, const QRectF& area, const QRectF& tool) : m_painter(painter), m_area(area) {
        m_scale = std::min(area.width() / std::max(2 * tool.right(), 1e-9),
                           area.height() / std::max(tool.height(), 1e-9));
        m_bottom = area.center().y() + m_scale * tool.height() / 2;
    }

    void draw(const HalfOutline& half, const QColor& fill, const QColor& line) const {
        QPolygonF whole;
        for (const QPointF& point : half)
            whole << at(point.x(), point.y());
        for (qsizetype k = half.size(); k > 0; --k)
            whole << at(-half[k - 1].x(), half[k - 1].y());
        m_painter.setPen(QPen(line, 1));
        m_painter.setBrush(fill);
        m_painter.drawPolygon(whole);
    }

    /// A height from the tip, as a dimension line at the right of the drawing.
    void dimension(double height, double right, const QString& text, const QColor& colour) const {
        const double low = at(0, 0).y();
        const double high = at(0, height).y();
        m_painter.setPen(QPen(colour, 1));
        m_painter.drawLine(QPointF(right, low), QPointF(right, high));
        for (const double y : {low, high})
            m_painter.drawLine(QPointF(right - kTick, y), QPointF(right + kTick, y));
        const QFontMetricsF metrics(m_painter.font());
        const QRectF place(right + kTick + 1, (low + high) / 2 - metrics.height() / 2,
                           metrics.horizontalAdvance(text) + 2, metrics.height());
        m_painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter, text);
    }

    void axis(double top, const QColor& colour) const {
        m_painter.setPen(QPen(colour, 1, Qt::DashDotLine));
        m_painter.drawLine(at(0, 0) + QPointF(0, kMargin / 2), at(0, top) - QPointF(0, kMargin / 2));
    }

    [[nodiscard]] QPointF at(double r, double z) const {
        return {m_area.center().x() + m_scale * r, m_bottom - m_scale * z};
    }

private:
    QPainter& m_painter;
    QRectF m_area;
    double m_scale = 1;
    double m_bottom = 0;
};

QColor mixed(const QColor& a, const QColor& b, double part) {
    return QColor::fromRgbF(static_cast<float>(a.redF() + (b.redF() - a.redF()) * part),
                            static_cast<float>(a.greenF() + (b.greenF() - a.greenF()) * part),
                            static_cast<float>(a.blueF() + (b.blueF() - a.blueF()) * part));
}

} // namespace

ToolDrawing::ToolDrawing(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    describeIt();
}

void ToolDrawing::describeIt() {
    setAccessibleName(tr("Drawing of the tool"));
    setToolTip(tr("The tool to scale: cutting part, shank, holder"));
}

void ToolDrawing::show(std::optional<Cutter> cutter) {
    m_cutter = std::move(cutter);
    update();
}

QSize ToolDrawing::sizeHint() const {
    return {kLeastWidth, kHeight};
}

QSize ToolDrawing::minimumSizeHint() const {
    return sizeHint();
}

void ToolDrawing::paintEvent(QPaintEvent* /*event*/) {
    if (!m_cutter)
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const std::array parts{cuttingPart(*m_cutter), shank(*m_cutter), holder(*m_cutter)};
    QRectF tool;
    for (const HalfOutline& part : parts)
        tool = tool.united(part.boundingRect());
    const auto text = [this](double millimetres) { return locale().toString(millimetres, 'g', 4); };
    const QString diameter = QStringLiteral("⌀ %1").arg(text(2 * m_cutter->radius()));
    const QFontMetricsF metrics(painter.font());
    const double numbers = metrics.horizontalAdvance(QStringLiteral("000.00")) + 3 * kTick;
    const QRectF area(kMargin + numbers, kMargin, width() - 2 * (kMargin + numbers),
                      height() - 2 * kMargin - metrics.height());
    const Sheet sheet(painter, area, tool);
    const QColor ink = palette().color(QPalette::WindowText);
    const QColor paper = palette().color(QPalette::Window);
    constexpr std::array kShades{0.15, 0.3, 0.5};
    for (std::size_t k = 0; k < parts.size(); ++k)
        if (!parts[k].isEmpty())
            sheet.draw(parts[k], mixed(paper, ink, kShades[k]), mixed(paper, ink, 0.8));
    sheet.axis(tool.bottom(), mixed(paper, ink, 0.5));
    sheet.dimension(m_cutter->fluteLength(), sheet.at(m_cutter->radius(), 0).x() + 2 * kTick,
                    text(m_cutter->fluteLength()), ink);
    if (m_cutter->body().stickOut > 0)
        sheet.dimension(m_cutter->body().stickOut, kMargin + kTick, text(m_cutter->body().stickOut), ink);
    painter.drawText(QRectF(0, sheet.at(0, 0).y() + kMargin / 2, width(), metrics.height()), Qt::AlignCenter,
                     diameter);
}

void ToolDrawing::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        describeIt();
}

} // namespace proveout
