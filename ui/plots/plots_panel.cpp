// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plots_panel.h"

#include <algorithm>
#include <array>
#include <utility>

#include <QClipboard>
#include <QFile>
#include <QGuiApplication>
#include <QMenu>
#include <QToolBar>
#include <QVBoxLayout>

#include "core/base/atomic_file.h"
#include "ui/files/save_dialog.h"
#include "ui/plots/plot_csv.h"

namespace proveout {
namespace {

constexpr std::size_t kShownAtFirst = 2; ///< the two figures of the paper
constexpr double kPngScale = 2;
constexpr std::size_t kValuesAtOnce = std::size_t{1} << 18; ///< some 10 ms
constexpr std::size_t kFewValues = kValuesAtOnce / 16;      ///< of one plot; also fast if all plots are shown

struct ExportRow {
    PlotFormat format;
    const char* suffix;
    const char* action;
    const char* filter;
};

/// Same order as PlotFormat.
constexpr std::array kExports{
    ExportRow{PlotFormat::csv, "csv", QT_TRANSLATE_NOOP("PlotsPanel", "Export as &CSV…"),
              QT_TRANSLATE_NOOP("PlotsPanel", "CSV (*.csv)")},
    ExportRow{PlotFormat::png, "png", QT_TRANSLATE_NOOP("PlotsPanel", "Export as &PNG…"),
              QT_TRANSLATE_NOOP("PlotsPanel", "PNG (*.png)")},
    ExportRow{PlotFormat::svg, "svg", QT_TRANSLATE_NOOP("PlotsPanel", "Export as &SVG…"),
              QT_TRANSLATE_NOOP("PlotsPanel", "SVG (*.svg)")},
};

} // namespace

PlotsPanel::PlotsPanel(Session& session, QWidget* parent)
    : QWidget(parent), m_session(session), m_bar(new QToolBar(this)), m_grid(new PlotGrid(this)),
      m_follow(new QAction(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_bar);
    layout->addWidget(m_grid, 1);

    for (const PlotSpec& spec : plotCatalogue())
        addView(spec, m_views.size() < kShownAtFirst);
    m_bar->addSeparator();
    m_follow->setCheckable(true);
    m_follow->setChecked(true);
    m_bar->addAction(m_follow);
    addActions(m_bar->actions()); // The main window shows them in its menus.
    connect(m_follow, &QAction::triggered, this, [this](bool on) {
        for (PlotView* view : m_views) {
            view->setFollowing(on);
            view->setBlock(m_block, m_blockCount);
        }
    });
    setTexts();
    m_fill.setSingleShot(true);
    connect(&m_fill, &QTimer::timeout, this, &PlotsPanel::fill);
    connect(&session.playback(), &PlaybackHub::tick, this, &PlotsPanel::refresh);
}

void PlotsPanel::addView(const PlotSpec& spec, bool shown) {
    auto* view = new PlotView(spec); // the grid takes ownership
    view->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(view, &PlotView::blockClicked, &m_session.playback(), &PlaybackHub::seek);
    connect(view, &PlotView::followingChanged, this,
            [this] { m_follow->setChecked(std::ranges::all_of(m_views, &PlotView::following)); });
    connect(view, &QWidget::customContextMenuRequested, this,
            [this, view](const QPoint& position) { openMenu(*view, position); });
    m_grid->add(view);
    m_grid->setShown(*view, shown);
    m_views.push_back(view);
    m_stale.emplace_back();

    QAction* action = m_bar->addAction(QString());
    action->setCheckable(true);
    action->setChecked(shown);
    action->setObjectName(QStringLiteral("plot-") + QLatin1String(spec.id));
    connect(action, &QAction::toggled, view, [this, view](bool on) {
        m_grid->setShown(*view, on);
        fill();
        view->setBlock(m_block, m_blockCount);
    });
    m_shown.push_back(action);
}

void PlotsPanel::setTexts() {
    setAccessibleName(tr("Plots"));
    for (std::size_t index = 0; index < m_views.size(); ++index) {
        const QString title = QCoreApplication::translate("Plots", m_views[index]->spec().title);
        m_shown[index]->setText(title);
        m_shown[index]->setToolTip(tr("Show or hide the plot \"%1\"").arg(title));
    }
    m_follow->setText(tr("Follow"));
    m_follow->setToolTip(tr("Keep the current block in view; dragging a plot turns this off"));
}

void PlotsPanel::addKeys(QAction* action) {
    for (PlotView* view : m_views)
        view->addAction(action);
}

/// Returns whether the times have changed.
bool PlotsPanel::useTimes(const Frame* frame) {
    const auto& known = m_session.program().times();
    const bool fits = known && frame != nullptr && known->program == frame->program;
    const auto times = fits ? known : nullptr;
    return std::exchange(m_times, times) != times;
}

PlotInput PlotsPanel::input() const {
    return {m_history.blocks(), m_history.frames(), m_times.get(), m_program.get()};
}

void PlotsPanel::refresh() {
    if (!isVisible())
        return; // The update follows when the panel is shown.
    static const PersistentArray<BlockStatistics> kNone;
    const FramePtr& frame = m_session.simulation().frame();
    if (const std::uint64_t generation = frame ? frame->generation : 0; generation != m_generation) {
        m_generation = generation;
        m_history.forgetFrames();
    }
    const PlotHistory::Changes changes =
        m_history.update(frame ? frame->statistics : kNone, m_session.playback().frameStatistics(),
                         m_session.playback().state().playing);
    const bool retimed = useTimes(frame.get());
    const bool moved =
        m_block != m_session.simulation().block() || m_blockCount != m_session.program().blockCount();
    const bool filled = std::exchange(m_filled, false);
    if (!changes.any && !moved && !retimed && !filled && !isBehind())
        return;
    m_block = m_session.simulation().block();
    m_blockCount = m_session.program().blockCount();
    m_program = frame ? frame->program : nullptr;
    const std::size_t rows = m_history.blocks().size();
    m_trace.update(frame ? frame->parameters : m_session.job().parameters(), changes.blocks.first, m_block,
                   rows);
    noteGaps(changes.blocks);
    const std::vector<std::size_t> parameterChanges = m_trace.changes();
    for (std::size_t index = 0; index < m_views.size(); ++index) {
        const PlotSpec& spec = m_views[index]->spec();
        m_views[index]->setParameterChanges(parameterChanges);
        RowRange changed = changes.blocks;
        if (spec.picture != nullptr)
            changed.include(changes.pictured);
        if (retimed && spec.timed)
            changed.include({0, rows});
        addStale(index, changed);
        m_stale[index].limit(rows);
    }
    fill();
    for (PlotView* view : m_views)
        if (view->isVisible())
            view->setBlock(m_block, m_blockCount);
}

bool PlotsPanel::isBehind() const {
    for (std::size_t index = 0; index < m_views.size(); ++index) {
        const PlotView& view = *m_views[index];
        // Rows that were dropped while the plot was hidden are not in m_stale.
        if (view.isVisible() && (!m_stale[index].empty() || view.rows() != m_history.blocks().size()))
            return true;
    }
    return false;
}

void PlotsPanel::addStale(std::size_t index, const RowRange& changed) {
    PlotView& view = *m_views[index];
    RowRange& stale = m_stale[index];
    const bool before = !stale.empty() && changed.end <= std::min(stale.first, view.rows());
    const bool few = changed.size() * view.spec().series.size() <= kFewValues;
    if (view.isVisible() && !changed.empty() && before && few)
        view.setRows(input(), changed);
    else
        stale.include(changed);
}

void PlotsPanel::fill() {
    const PlotInput shown = input();
    std::size_t left = kValuesAtOnce;
    bool more = false;
    const std::size_t from = m_fillFrom;
    for (std::size_t k = 0; k < m_views.size(); ++k) {
        const std::size_t index = (from + k) % m_views.size();
        PlotView& view = *m_views[index];
        if (!view.isVisible())
            continue;
        const std::size_t curves = view.spec().series.size();
        const RowRange now = m_stale[index].takeFront(left / curves);
        view.setRows(shown, now);
        left -= now.size() * curves;
        if (more || m_stale[index].empty())
            continue;
        // The first view that is not finished used up the limit, so the next one is first the next time.
        more = true;
        m_fillFrom = now.empty() ? index : index + 1;
    }
    if (more)
        return m_fill.start();
    if (sender() != &m_fill)
        return; // the caller repaints
    m_filled = true;
    m_session.playback().requestTick();
}

void PlotsPanel::fillAll(PlotView& view) {
    const auto index = static_cast<std::size_t>(std::ranges::find(m_views, &view) - m_views.begin());
    view.setRows(input(), std::exchange(m_stale[index], {}));
    view.setBlock(m_block, m_blockCount); // fits the axes to the new rows
}

void PlotsPanel::noteGaps(const RowRange& changed) {
    const PersistentArray<BlockStatistics>& rows = m_history.blocks();
    m_firstGap = std::min(m_firstGap, rows.size());
    for (std::size_t row = changed.first; row < std::min(changed.end, m_firstGap); ++row)
        if (!rows[row].isPlayed())
            m_firstGap = row;
    while (m_firstGap < rows.size() && rows[m_firstGap].isPlayed())
        ++m_firstGap;
    for (PlotView* view : m_views)
        view->hint().setIncomplete(view->spec().measured && m_firstGap < rows.size());
}

QString PlotsPanel::csv(const PlotView& view) const {
    return QString::fromStdString(plotCsv(view.spec(), input()));
}

bool PlotsPanel::exportTo(PlotView& view, const QString& file, PlotFormat format) {
    fillAll(view);
    QByteArray bytes;
    switch (format) {
    case PlotFormat::csv:
        bytes = csv(view).toUtf8();
        break;
    case PlotFormat::png:
        bytes = view.png(kPngScale);
        break;
    case PlotFormat::svg:
        bytes = view.svg();
        break;
    }
    const auto written =
        writeFile(QFile::encodeName(file).toStdString(),
                  std::string_view(bytes.constData(), static_cast<std::size_t>(bytes.size())));
    if (!written)
        m_session.problems().report(written.error());
    return written.has_value();
}

bool PlotsPanel::askAndExport(PlotView& view, PlotFormat format) {
    const ExportRow& row = kExports[static_cast<std::size_t>(format)];
    const QString suffix = QLatin1String(row.suffix);
    const QString file = askWhereToSave(
        *this, tr("Export Plot"), QLatin1String(view.spec().id) + u'.' + suffix, tr(row.filter), suffix);
    return !file.isEmpty() && exportTo(view, file, format);
}

void PlotsPanel::openMenu(PlotView& view, const QPoint& position) {
    QMenu menu(this);
    for (const ExportRow& row : kExports)
        menu.addAction(tr(row.action), [this, &view, format = row.format] { askAndExport(view, format); });
    menu.addAction(tr("C&opy Data as CSV"), [&] { QGuiApplication::clipboard()->setText(csv(view)); });
    menu.addSeparator();
    menu.addAction(tr("Show &All Blocks"), [&] { view.showAll(); });
    menu.exec(view.mapToGlobal(position));
}

void PlotsPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    refresh();
}

void PlotsPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        setTexts();
    QWidget::changeEvent(event);
}

} // namespace proveout
