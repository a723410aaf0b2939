// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <QAction>
#include <QTimer>
#include <QWidget>

#include "ui/plots/parameter_trace.h"
#include "ui/plots/plot_changes.h"
#include "ui/plots/plot_grid.h"
#include "ui/plots/plot_view.h"
#include "ui/plots/row_range.h"
#include "ui/session/session.h"

class QToolBar;

namespace proveout {

/// The file format of an exported plot.
enum class PlotFormat : std::uint8_t { csv, png, svg };

/// The plots of the catalogue in rows, updated live; a button shows or hides each plot. Clicking a plot
/// seeks. Thread: UI.
class PlotsPanel : public QWidget {
    Q_OBJECT

public:
    explicit PlotsPanel(Session& session, QWidget* parent = nullptr);

    /// Same order as plotCatalogue().
    [[nodiscard]] const std::vector<PlotView*>& views() const { return m_views; }
    /// The action's keys are active while a plot has the focus.
    void addKeys(QAction* action);
    [[nodiscard]] QString csv(const PlotView& view) const;
    /// The extension of the file does not matter. Errors are reported to the session.
    bool exportTo(PlotView& view, const QString& file, PlotFormat format);
    /// Asks for the file; also false if the user cancels.
    bool askAndExport(PlotView& view, PlotFormat format);

protected:
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void refresh();
    /// Whether a shown plot does not have the current rows.
    [[nodiscard]] bool isBehind() const;
    /// Adds rows to those of a view that are not up to date. A few rows before the ones that fill() has yet
    /// to update are updated immediately, because fill() would otherwise start again at them on each tick.
    void addStale(std::size_t index, const RowRange& changed);
    /// Finds out whether a block was not measured; the other rows are as they were.
    void noteGaps(const RowRange& changed);
    /// Updates the rows of the shown plots, a limited number of them at once, and continues after other
    /// events; then requests a tick.
    void fill();
    void fillAll(PlotView& view);
    [[nodiscard]] bool useTimes(const Frame* frame);
    [[nodiscard]] PlotInput input() const;
    void addView(const PlotSpec& spec, bool shown);
    void setTexts();
    void openMenu(PlotView& view, const QPoint& position);

    Session& m_session;
    PlotHistory m_history;
    ParameterTrace m_trace;
    std::shared_ptr<const Program> m_program;    ///< the program of m_history
    std::shared_ptr<const MachineTimes> m_times; ///< times for the program of m_history; null: not known yet
    std::uint64_t m_generation = 0;              ///< generation of the frame that last updated m_history
    std::size_t m_firstGap = 0; ///< the first row that was not measured; the number of rows if all were
    QToolBar* m_bar;
    PlotGrid* m_grid;
    QAction* m_follow;
    std::vector<PlotView*> m_views;
    std::vector<QAction*> m_shown; ///< one per view
    /// The rows of each view that are not up to date; those of a hidden one stay so until it is shown.
    std::vector<RowRange> m_stale;
    std::size_t m_fillFrom = 0; ///< the view that the next fill() begins with, so that each gets its turn
    QTimer m_fill;              ///< active while there is more to fill
    bool m_filled = false;      ///< since the last tick
    std::size_t m_block = 0;
    std::size_t m_blockCount = 0;
};

} // namespace proveout
