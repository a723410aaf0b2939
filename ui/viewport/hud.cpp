// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/hud.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <QCoreApplication>
#include <QLocale>

namespace proveout {
namespace {

constexpr int kMargin = 14;
constexpr int kSwatch = 26;
constexpr int kPadding = 9;
constexpr QChar kMinus(0x2212);

QColor colour(const glm::vec3& c) {
    return QColor::fromRgbF(c.r, c.g, c.b);
}

QString text(const char* source) {
    return QCoreApplication::translate("Viewport", source);
}

enum class Mark : std::uint8_t { none, line, dashes, area, hatched };

struct Entry {
    Mark mark;
    QColor colour;
    QString text;
    double width = 2;
    bool onMetal = false;  ///< a dark line, because it is drawn on the stock
    QColor until = colour; ///< of an area whose colour changes from top to bottom
};

/// About the colour of the lit stock.
constexpr QColor kMetal(0xB8, 0xBC, 0xC4);

/// "+0.10": two decimals, or three where it needs them.
QString signedValue(const QLocale& locale, double value, QChar sign) {
    const bool isHundredths = std::abs(100 * value - std::round(100 * value)) < 1e-6;
    return sign + locale.toString(value, 'f', isHundredths ? 2 : 3);
}

void addDeviation(std::vector<Entry>& rows, const DeviationLegend& legend, const DeviationColours& colours,
                  const QLocale& locale) {
    using Band = DeviationLines::Band;
    const DeviationLines lines = linesOf(legend, locale);
    rows.push_back({Mark::none, {}, lines.title});
    for (const auto& [band, words] : lines.bands) {
        if (band == Band::excess)
            rows.push_back({Mark::area, colour(colours.excess), words});
        else if (band == Band::left)
            rows.push_back({.mark = Mark::area,
                            .colour = colour(colours.left),
                            .text = words,
                            .until = colour(colours.exact)});
        else if (band == Band::missing)
            rows.push_back({.mark = Mark::area,
                            .colour = colour(colours.exact),
                            .text = words,
                            .until = colour(colours.missing)});
        else
            rows.push_back({Mark::hatched, colour(colours.gouge), words});
    }
}

std::vector<Entry> entries(const SceneOptions& options, const LegendFigures& figures) {
    const SceneColours& colours = options.colours;
    const QLocale locale;
    const auto count = [&](std::size_t n) { return locale.toString(static_cast<qulonglong>(n)); };
    std::vector<Entry> rows;
    rows.push_back({Mark::none,
                    {},
                    text(QT_TRANSLATE_NOOP("Viewport", "%1 of %2 triangles"))
                        .arg(count(figures.faces), count(figures.facesFull))});
    if (options.path != PathShown::none) {
        rows.push_back({Mark::dashes, colour(colours.rapid), text(QT_TRANSLATE_NOOP("Viewport", "Rapid"))});
        rows.push_back({Mark::line, colour(colours.feed), text(QT_TRANSLATE_NOOP("Viewport", "Feed"))});
        rows.push_back({Mark::line, colour(colours.arc), text(QT_TRANSLATE_NOOP("Viewport", "Arc"))});
    }
    if (options.fixtures && figures.fixtures)
        rows.push_back({Mark::area, colour(colours.fixture), text(QT_TRANSLATE_NOOP("Viewport", "Fixture"))});
    if (figures.part)
        rows.push_back(
            {Mark::area, colour(colours.part), text(QT_TRANSLATE_NOOP("Viewport", "Design part"))});
    if (options.tint) {
        rows.push_back({Mark::area, colour(colours.dirty),
                        text(QT_TRANSLATE_NOOP("Viewport", "Drawn from the z-map: %1 regions"))
                            .arg(count(figures.dirtyRegions))});
        rows.push_back({Mark::area, colour(colours.decimated),
                        text(QT_TRANSLATE_NOOP("Viewport", "Decimated: %1 regions"))
                            .arg(count(figures.regions - figures.dirtyRegions))});
    }
    if (options.wireframe) {
        rows.push_back({Mark::line, colour(colours.regionLine),
                        text(QT_TRANSLATE_NOOP("Viewport", "Region border")), 3, true});
        rows.push_back({Mark::line, colour(colours.wire),
                        text(QT_TRANSLATE_NOOP("Viewport", "Triangle edge")), 1, true});
    }
    if (figures.deviation)
        addDeviation(rows, *figures.deviation, colours.deviation, locale);
    return rows;
}

/// A sentence in lines that are no wider than that, if its words are not.
QStringList wrapped(const QString& sentence, const QFontMetrics& metrics, int width) {
    QStringList lines;
    for (const QString& word : sentence.split(u' ', Qt::SkipEmptyParts)) {
        const QString longer = lines.isEmpty() ? word : lines.back() + u' ' + word;
        if (lines.isEmpty() || metrics.horizontalAdvance(longer) > width)
            lines.push_back(word);
        else
            lines.back() = longer;
    }
    return lines;
}

/// As the shader hatches it.
void paintHatched(QPainter& painter, const QRect& area, const QColor& background) {
    constexpr int kFromLineToLine = 8;
    painter.fillRect(area, background);
    painter.save();
    painter.setClipRect(area);
    painter.setPen(QPen(background.darker(160), 2));
    for (int x = area.left() - area.height(); x < area.right(); x += kFromLineToLine)
        painter.drawLine(QPointF(x, area.top()), QPointF(x + area.height(), area.bottom() + 1));
    painter.restore();
}

void paintMark(QPainter& painter, const QRect& box, const Entry& entry) {
    const QRect area = box.adjusted(0, box.height() / 5, 0, -box.height() / 5);
    if (entry.mark == Mark::hatched)
        return paintHatched(painter, area, entry.colour);
    if (entry.mark == Mark::area) {
        QLinearGradient colours(area.topLeft(), area.bottomLeft());
        colours.setColorAt(0, entry.colour);
        colours.setColorAt(1, entry.until);
        painter.fillRect(area, colours);
        return;
    }
    if (entry.onMetal)
        painter.fillRect(area, kMetal);
    QPen pen(entry.colour, entry.width);
    pen.setCapStyle(Qt::FlatCap);
    if (entry.mark == Mark::dashes)
        pen.setDashPattern({3, 2});
    painter.setPen(pen);
    const double y = box.center().y() + 0.5;
    painter.drawLine(QPointF(box.left(), y), QPointF(box.right(), y));
}

void paintPlate(QPainter& painter, const QRect& box, const QPalette& palette) {
    QColor plate = palette.color(QPalette::Base);
    plate.setAlphaF(0.82f);
    painter.setPen(Qt::NoPen);
    painter.setBrush(plate);
    painter.drawRoundedRect(box, 5, 5);
    painter.setBrush(Qt::NoBrush);
}

} // namespace

DeviationLines linesOf(const DeviationLegend& legend, const QLocale& locale) {
    using Band = DeviationLines::Band;
    const PartTolerance& tolerance = legend.tolerance;
    const QString above = signedValue(locale, tolerance.above, u'+');
    const QString below = signedValue(locale, tolerance.below, kMinus);
    DeviationLines lines;
    lines.title = tolerance.allowance == 0
                      ? text(QT_TRANSLATE_NOOP("Viewport", "Deviation from the part, mm"))
                      : text(QT_TRANSLATE_NOOP("Viewport", "Deviation from the part with allowance %1, mm"))
                            .arg(signedValue(locale, std::abs(tolerance.allowance),
                                             tolerance.allowance > 0 ? QChar(u'+') : kMinus));
    lines.bands.emplace_back(Band::excess, text(QT_TRANSLATE_NOOP("Viewport", "> %1 (excess)")).arg(above));
    if (tolerance.above > 0)
        lines.bands.emplace_back(Band::left, QStringLiteral("0 … %1").arg(above));
    if (tolerance.below > 0)
        lines.bands.emplace_back(Band::missing, QStringLiteral("0 … %1").arg(below));
    lines.bands.emplace_back(Band::gouge, text(QT_TRANSLATE_NOOP("Viewport", "< %1 (gouge)")).arg(below));
    return lines;
}

void paintAxes(QPainter& painter, const QRect& area, const View& view, const QColor& textColour) {
    constexpr double kLength = 34;
    struct Axis {
        const char* name;
        glm::dvec3 direction;
        QColor colour;
    };
    std::array axes{Axis{"X", {1, 0, 0}, QColor(0xD5, 0x3E, 0x2A)},
                    Axis{"Y", {0, 1, 0}, QColor(0x2E, 0x9E, 0x4F)},
                    Axis{"Z", {0, 0, 1}, QColor(0x2F, 0x7F, 0xE0)}};
    // Starts with the farthest one.
    std::ranges::sort(axes, {}, [&](const Axis& axis) { return glm::dot(axis.direction, view.back); });
    const QPointF origin(area.left() + kMargin + 44, area.bottom() - kMargin - 44);
    for (const Axis& axis : axes) {
        const QPointF along(glm::dot(axis.direction, view.right), -glm::dot(axis.direction, view.up));
        painter.setPen(QPen(axis.colour, 3, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(origin, origin + along * kLength);
        const QRectF letter(origin + along * (kLength + 11) - QPointF(10, 10), QSizeF(20, 20));
        painter.setPen(textColour);
        painter.drawText(letter, Qt::AlignCenter, QLatin1String(axis.name));
    }
}

void paintLegend(QPainter& painter, const QRect& area, const SceneOptions& options,
                 const LegendFigures& figures, const QPalette& palette) {
    std::vector<Entry> rows = entries(options, figures);
    const QFontMetrics metrics = painter.fontMetrics();
    const int line = metrics.height() + 5;
    int width = 0;
    for (const Entry& row : rows)
        width =
            std::max(width, metrics.horizontalAdvance(row.text) + (row.mark == Mark::none ? 0 : kSwatch + 8));
    if (figures.deviation)
        for (const QString& words : wrapped(figures.deviation->note, metrics, width))
            rows.push_back({Mark::none, {}, words});
    const QRect plate(area.left() + kMargin, area.top() + kMargin, width + 2 * kPadding,
                      line * static_cast<int>(rows.size()) + 2 * kPadding - 5);
    paintPlate(painter, plate, palette);
    int y = plate.top() + kPadding;
    for (const Entry& row : rows) {
        int x = plate.left() + kPadding;
        if (row.mark != Mark::none) {
            paintMark(painter, {x, y, kSwatch, metrics.height()}, row);
            x += kSwatch + 8;
        }
        painter.setPen(palette.color(QPalette::Text));
        painter.drawText(x, y + metrics.ascent(), row.text);
        y += line;
    }
}

void paintRemark(QPainter& painter, const QRect& area, const QString& sentence, const QPalette& palette) {
    const int margin = kMargin + kPadding;
    const QRect inner = area.adjusted(area.width() / 2, margin, -margin, -margin);
    constexpr int kPlace = Qt::AlignRight | Qt::AlignBottom | Qt::TextWordWrap;
    const QRect words = painter.fontMetrics().boundingRect(inner, kPlace, sentence);
    paintPlate(painter, words.adjusted(-kPadding, -kPadding, kPadding, kPadding), palette);
    painter.setPen(palette.color(QPalette::Text));
    painter.drawText(inner, kPlace, sentence);
}

void paintNotice(QPainter& painter, const QRect& area, const QString& sentence, const QPalette& palette) {
    const QRect inner = area.adjusted(4 * kMargin, 0, -4 * kMargin, 0);
    const QRect words =
        painter.fontMetrics().boundingRect(inner, Qt::AlignCenter | Qt::TextWordWrap, sentence);
    paintPlate(painter, words.adjusted(-kPadding, -kPadding, kPadding, kPadding), palette);
    painter.setPen(palette.color(QPalette::Text));
    painter.drawText(inner, Qt::AlignCenter | Qt::TextWordWrap, sentence);
}

} // namespace proveout
