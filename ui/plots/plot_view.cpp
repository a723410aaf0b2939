// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_view.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QApplication>
#include <QBuffer>
#include <QScrollBar>
#include <QSvgGenerator>
#include <QToolTip>

#include "ui/look/theme.h"

namespace proveout {
namespace {

constexpr double kZoomPerStep = 0.8;
constexpr double kNearPixels = 4;
constexpr int kMostTicks = 6;
constexpr int kTickHeight = 34; ///< px, a label with the space around it
constexpr int kBesides = 70;    ///< px around the curves: header, labels, axis titles
constexpr int kTickGap = 28;    ///< px between adjacent labels
/// Ratio of the highest to the lowest visible value above which a linear axis would flatten the low values.
constexpr double kWideValues = 8;
/// Free space above the highest value, and on a logarithmic axis also below the lowest one, as factors.
constexpr double kHeadroom = 1.06;
constexpr double kWideHeadroom = 1.4;
constexpr std::size_t kMostSmoothRows = 20000;
constexpr double kAheadOfBlock = 0.06; ///< share of the visible span that stays free after the current block

QString translated(const char* text) {
    return QCoreApplication::translate("Plots", text);
}

/// The colours of Okabe and Ito, slightly darker or lighter where the background requires more contrast.
QColor seriesColour(int index, bool dark) {
    static const std::array kLight{QColor(0x00, 0x5F, 0xA3), QColor(0x6B, 0x72, 0x7B),
                                   QColor(0xB8, 0x4A, 0x00), QColor(0x00, 0x7A, 0x5A),
                                   QColor(0x9C, 0x3F, 0x78)};
    static const std::array kDark{QColor(0x56, 0xB4, 0xE9), QColor(0x9A, 0xA3, 0xAD),
                                  QColor(0xF0, 0x8A, 0x35), QColor(0x2F, 0xC7, 0x9B),
                                  QColor(0xE0, 0x92, 0xC2)};
    const auto at = static_cast<std::size_t>(index) % kLight.size();
    return dark ? kDark[at] : kLight[at];
}

/// Formats a number of any size for the locale.
QString number(double value) {
    if (std::isnan(value))
        return QStringLiteral("–");
    const QLocale locale;
    if (value == std::floor(value) && std::abs(value) < 1e15)
        return locale.toString(static_cast<qlonglong>(value));
    if (std::abs(value) < 1)
        return locale.toString(value, 'g', 3);
    return locale.toString(value, 'f', std::abs(value) < 10 ? 3 : 1);
}

} // namespace

PlotView::PlotView(const PlotSpec& spec, QWidget* parent)
    : QCustomPlot(parent), m_spec(spec), m_header(*this, spec.series.size()),
      m_blockTicks(QSharedPointer<PlotTicks>::create()), m_valueTicks(QSharedPointer<PlotTicks>::create()),
      m_mark(new QCPItemStraightLine(this)), m_hint(*this) {
    setObjectName(QLatin1String(spec.id));
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(220, 110);
    setNoAntialiasingOnDrag(true);
    setPlottingHint(QCP::phFastPolylines, true);
    setNotAntialiasedElements(QCP::aeFills);
    m_blockTicks->setWhole(true);
    xAxis->setTicker(m_blockTicks);
    yAxis->setTicker(m_valueTicks);
    yAxis->setPadding(4);
    addCurves();
    setTexts();
    style();
    setBlock(0, 0);
}

void PlotView::addCurves() {
    for (std::size_t index = 0; index < m_spec.series.size(); ++index) {
        auto* curve = new RowCurve(xAxis, yAxis); // owned by the plot
        m_curves.push_back(curve);
        curve->setAdaptiveSampling(true);
        if (m_spec.stacked && index > 0)
            curve->setChannelFillGraph(graph(static_cast<int>(index) - 1));
    }
    // Draws stacked curves from top to bottom: where one adds nothing, the line below it must be visible.
    for (int index = graphCount() - 1; m_spec.stacked && index >= 0; --index)
        graph(index)->setLayer(graph(index)->layer());
}

void PlotView::setTexts() {
    setLocale(QLocale()); // the axes must group digits as the texts do
    m_header.setTitle(translated(m_spec.title));
    xAxis->setLabel(translated(m_spec.xLabel));
    setLogarithmic(yAxis->scaleType() == QCPAxis::stLogarithmic);
    for (std::size_t index = 0; index < m_spec.series.size(); ++index)
        graph(static_cast<int>(index))->setName(translated(m_spec.series[index].label));
    m_hint.retranslate();
    setAccessibleName(translated(m_spec.title));
    m_header.fit(width());
}

void PlotView::style() {
    const QColor text = palette().color(QPalette::Text);
    const QColor ground = palette().color(QPalette::Base);
    QColor grid = text;
    grid.setAlphaF(0.12f);
    QColor axisColour = text;
    axisColour.setAlphaF(0.55f);
    setBackground(ground);
    for (QCPAxis* axis : {xAxis, yAxis}) {
        for (const auto set : {&QCPAxis::setBasePen, &QCPAxis::setTickPen, &QCPAxis::setSubTickPen})
            (axis->*set)(QPen(axisColour, 1));
        axis->setLabelColor(text);
        axis->setTickLabelColor(text);
        axis->setLabelFont(font());
        axis->setTickLabelFont(font());
        axis->grid()->setPen(QPen(grid, 1));
        axis->grid()->setZeroLinePen(QPen(grid, 1));
    }
    m_header.style(font(), text);
    m_header.fit(width());
    styleChanges();
    m_hint.style(font(), text, ground);
    styleMark();
    styleCurves();
}

void PlotView::styleCurves() {
    const bool logarithmic = yAxis->scaleType() == QCPAxis::stLogarithmic;
    for (std::size_t index = 0; index < m_spec.series.size(); ++index) {
        const PlotSeries& series = m_spec.series[index];
        const QColor colour = seriesColour(series.colour, isDark(palette()));
        QCPGraph* curve = graph(static_cast<int>(index));
        // One pixel wide: Qt draws wider lines with its stroker, which takes minutes for a jagged curve.
        curve->setPen(QPen(colour, 1, series.pen));
        QColor fill = colour;
        fill.setAlphaF(series.fill == Qt::SolidPattern ? 0.22f : 0.75f);
        // An area represents an amount, which is not possible on a logarithmic axis.
        const bool filled = series.fill != Qt::NoBrush && !logarithmic;
        curve->setBrush(filled ? QBrush(fill, series.fill) : QBrush(Qt::NoBrush));
    }
}

/// Wider with the focus, as on the timeline, because the arrow keys move it then.
void PlotView::styleMark() {
    m_mark->setPen(QPen(meaningColors(palette()).accent, hasFocus() ? 3 : 1.5));
}

void PlotView::setRows(const PlotInput& input, RowRange changed) {
    changed.limit(input.blocks.size());
    std::vector<double> values(changed.size(), 0.0);
    for (std::size_t index = 0; index < m_curves.size(); ++index) {
        for (std::size_t k = 0; k < values.size(); ++k) {
            const double y = m_spec.y(input, changed.first + k, index);
            values[k] = m_spec.stacked ? values[k] + y : y;
        }
        m_curves[index]->keepRows(input.blocks.size());
        m_curves[index]->setValues(changed.first, values);
    }
    // With more rows than pixels a curve is a band: antialiasing it is invisible and doubles the cost.
    setNotAntialiasedElement(QCP::aePlottables, rows() > kMostSmoothRows);
    if (m_spec.picture == nullptr)
        return;
    m_pictures.resize(rows());
    for (std::size_t row = changed.first; row < changed.end; ++row)
        m_pictures[row] = m_spec.picture(input, row);
}

QCPGraphDataContainer::const_iterator PlotView::pointOf(std::size_t series, std::size_t row) const {
    return graph(static_cast<int>(series))->data()->constBegin() + static_cast<std::ptrdiff_t>(row);
}

double PlotView::value(std::size_t series, std::size_t row) const {
    const double below = m_spec.stacked && series > 0 ? pointOf(series - 1, row)->value : 0;
    return pointOf(series, row)->value - below;
}

// --- what is shown

void PlotView::setFollowing(bool following) {
    if (following == m_following)
        return;
    m_following = following;
    emit followingChanged(following);
}

void PlotView::showAll() {
    m_span = 0;
    setFollowing(true);
    setBlock(m_block, m_blockCount);
}

void PlotView::setBlock(std::size_t block, std::size_t blockCount) {
    m_block = block;
    m_blockCount = blockCount;
    const auto x = static_cast<double>(block);
    m_mark->point1->setCoords(x, 0);
    m_mark->point2->setCoords(x, 1);
    fitAxes();
    // Queued, so that all plots and the 3D view are repainted together.
    replot(rpQueuedRefresh);
}

void PlotView::setParameterChanges(const std::vector<std::size_t>& blocks) {
    while (m_changes.size() > blocks.size()) {
        removeItem(m_changes.back());
        m_changes.pop_back();
    }
    const bool added = m_changes.size() < blocks.size();
    while (m_changes.size() < blocks.size())
        m_changes.push_back(new QCPItemStraightLine(this));
    for (std::size_t k = 0; k < blocks.size(); ++k) {
        m_changes[k]->point1->setCoords(static_cast<double>(blocks[k]), 0);
        m_changes[k]->point2->setCoords(static_cast<double>(blocks[k]), 1);
    }
    if (added)
        styleChanges();
}

void PlotView::styleChanges() {
    QColor colour = palette().color(QPalette::Text);
    colour.setAlphaF(0.7f);
    for (QCPItemStraightLine* line : m_changes)
        line->setPen(QPen(colour, 1, Qt::DashLine));
}

void PlotView::fitAxes() {
    if (m_following) {
        double end = std::max(1.0, static_cast<double>(m_blockCount));
        double begin = 0;
        if (m_span > 0 && m_span < end) {
            end = std::min(end, static_cast<double>(m_block) + kAheadOfBlock * m_span);
            begin = std::max(0.0, end - m_span);
            end = begin + m_span;
        }
        xAxis->setRange(begin, end);
    }
    fitValues();
    fitTicks();
    const bool measured = rows() > 0;
    m_hint.setEmpty(!measured);
    yAxis->setTickLabels(measured); // without curves the labels would mean nothing
}

void PlotView::fitValues() {
    const auto values = valuesInSight();
    const bool logarithmic = m_spec.wide && values && values->upper > kWideValues * values->lower;
    if (logarithmic != (yAxis->scaleType() == QCPAxis::stLogarithmic))
        setLogarithmic(logarithmic);
    if (logarithmic)
        yAxis->setRange(values->lower / kWideHeadroom, values->upper * kWideHeadroom);
    else
        yAxis->setRange(0, values ? values->upper * kHeadroom : 1);
}

/// Uses as many ticks as their labels have space for.
void PlotView::fitTicks() {
    const QString last = shortNumber(static_cast<double>(std::max(m_block, m_blockCount)), QLocale());
    const int width = QFontMetrics(xAxis->tickLabelFont()).horizontalAdvance(last) + kTickGap;
    m_blockTicks->setTickCount(std::clamp((this->width() - kBesides) / width, 2, kMostTicks));
    m_valueTicks->setTickCount(std::clamp((height() - kBesides) / kTickHeight, 2, kMostTicks));
}

void PlotView::setLogarithmic(bool on) {
    yAxis->setScaleType(on ? QCPAxis::stLogarithmic : QCPAxis::stLinear);
    m_valueTicks->setLogarithmic(on);
    const QString label = translated(m_spec.yLabel);
    yAxis->setLabel(on ? tr("%1 (log)").arg(label) : label);
    styleCurves();
}

std::optional<QCPRange> PlotView::valuesInSight() const {
    std::optional<QCPRange> values;
    for (const RowCurve* curve : m_curves) {
        const auto range = curve->valuesAbove0(xAxis->range());
        if (range && values)
            values->expand(*range);
        else if (range)
            values = range;
    }
    return values;
}

std::size_t PlotView::rowAt(double block) const {
    const auto points = graph(0)->data();
    auto found = points->findBegin(block, false); // the first point at or after `block`
    found = std::clamp(found, points->constBegin(), points->constEnd() - 1);
    if (found != points->constBegin() && block - (found - 1)->key < found->key - block)
        --found;
    return static_cast<std::size_t>(found - points->constBegin());
}

std::optional<std::size_t> PlotView::peakAt(double pixelX) const {
    const auto points = graph(graphCount() - 1)->data();
    const double left = std::floor(pixelX);
    const auto first = points->findBegin(xAxis->pixelToCoord(left), false);
    const auto last = points->findEnd(xAxis->pixelToCoord(left + 1), false);
    if (last - first < 2)
        return std::nullopt;
    auto peak = first;
    for (auto point = first; point != last; ++point) {
        if (point->value > peak->value || std::isnan(peak->value))
            peak = point;
    }
    return static_cast<std::size_t>(peak - points->constBegin());
}

/// States which values of a row are means, and over which blocks.
QString PlotView::pictureText(std::size_t row) const {
    if (m_spec.picture == nullptr)
        return {};
    const PictureBlocks& picture = m_pictures[row];
    if (picture.first == picture.last)
        return u'\n' + tr("Not drawn yet");
    if (picture.last - picture.first == 1)
        return {};
    return u'\n' + tr("Upload and drawing: mean of blocks %1 to %2 (one frame)")
                       .arg(number(picture.first + 1.0), number(picture.last));
}

QString PlotView::valuesAt(double pixelX) const {
    if (rows() == 0)
        return {};
    const std::size_t row = peakAt(pixelX).value_or(rowAt(xAxis->pixelToCoord(pixelX)));
    QString text =
        QStringLiteral("%1 %2\n%3")
            .arg(translated(m_spec.xLabel), number(static_cast<double>(row + 1)), translated(m_spec.yLabel));
    for (std::size_t index = 0; index < m_spec.series.size(); ++index)
        text +=
            QStringLiteral("\n%1: %2").arg(translated(m_spec.series[index].label), number(value(index, row)));
    text += pictureText(row);
    if (std::ranges::any_of(m_changes, [&](const QCPItemStraightLine* line) {
            return std::abs(line->point1->pixelPosition().x() - pixelX) < kNearPixels;
        }))
        text += u'\n' + tr("Parameters changed here");
    return text;
}

// --- user input

void PlotView::mousePressEvent(QMouseEvent* event) {
    m_dragged = false;
    m_pressed = event->position();
}

void PlotView::mouseMoveEvent(QMouseEvent* event) {
    if ((event->buttons() & Qt::LeftButton) == 0) {
        // A tooltip is a separate window, so showing it does not repaint the main window.
        QToolTip::showText(event->globalPosition().toPoint(), valuesAt(event->position().x()), this);
        return;
    }
    if (!m_dragged && (event->position() - m_pressed).manhattanLength() < QApplication::startDragDistance())
        return;
    m_dragged = true;
    setFollowing(false);
    const double moved = xAxis->pixelToCoord(m_pressed.x()) - xAxis->pixelToCoord(event->position().x());
    m_pressed = event->position();
    xAxis->moveRange(moved);
    setBlock(m_block, m_blockCount);
}

void PlotView::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || m_dragged || !axisRect()->rect().contains(event->pos()))
        return;
    const double x = event->position().x();
    const auto peak = peakAt(x);
    const double block = peak ? pointOf(0, *peak)->key : std::round(xAxis->pixelToCoord(x));
    emit blockClicked(static_cast<std::size_t>(std::clamp(block, 0.0, static_cast<double>(m_blockCount))));
}

void PlotView::mouseDoubleClickEvent(QMouseEvent*) {
    m_dragged = true; // The release that follows is not a click.
    showAll();
}

void PlotView::wheelEvent(QWheelEvent* event) {
    if (m_scrollBar != nullptr && !event->modifiers().testFlag(Qt::ControlModifier)) {
        QCoreApplication::sendEvent(m_scrollBar, event);
        return event->accept();
    }
    const double steps = event->angleDelta().y() / double{QWheelEvent::DefaultDeltasPerStep};
    const double whole = std::max(1.0, static_cast<double>(m_blockCount));
    xAxis->scaleRange(std::pow(kZoomPerStep, steps), xAxis->pixelToCoord(event->position().x()));
    if (xAxis->range().size() >= whole) {
        showAll();
    } else {
        m_span = std::max(xAxis->range().size(), 5.0);
        // The position under the pointer stays fixed; following later continues with this span.
        setFollowing(false);
        setBlock(m_block, m_blockCount);
    }
    event->accept();
}

void PlotView::resizeEvent(QResizeEvent* event) {
    m_header.fit(width());
    QCustomPlot::resizeEvent(event);
    fitTicks();
    replot(rpQueuedRefresh);
}

void PlotView::focusInEvent(QFocusEvent* event) {
    QCustomPlot::focusInEvent(event);
    styleMark();
    replot(rpQueuedRefresh);
}

void PlotView::focusOutEvent(QFocusEvent* event) {
    QCustomPlot::focusOutEvent(event);
    styleMark();
    replot(rpQueuedRefresh);
}

void PlotView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        style();
        replot(rpQueuedRefresh);
    } else if (event->type() == QEvent::LanguageChange) {
        setTexts();
        replot(rpQueuedRefresh);
    }
    QCustomPlot::changeEvent(event);
}

// --- export

QByteArray PlotView::png(double scale) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    toPixmap(width(), height(), scale).save(&buffer, "PNG");
    return bytes;
}

QByteArray PlotView::svg() {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setSize(size());
    generator.setViewBox(rect());
    generator.setTitle(translated(m_spec.title));
    QCPPainter painter;
    painter.begin(&generator);
    painter.setMode(QCPPainter::pmVectorized);
    toPainter(&painter, width(), height());
    painter.end();
    return bytes;
}

} // namespace proveout
