// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <QAction>
#include <QWidget>

#include "ui/plots/parameter_trace.h"
#include "ui/plots/plot_changes.h"
#include "ui/plots/plot_grid.h"
#include "ui/plots/plot_view.h"
#include "ui/session/session.h"

class QToolBar;

namespace proveout {

/// What a plot is exported as.
enum class PlotFormat : std::uint8_t { csv, png, svg };

/// The plots of the catalogue in rows, live; a button shows or hides each. Clicking a plot seeks.
/// Thread: UI.
class PlotsPanel : public QWidget {
    Q_OBJECT

public:
    explicit PlotsPanel(Session& session, QWidget* parent = nullptr);

    /// In the order of plotCatalogue().
    [[nodiscard]] const std::vector<PlotView*>& views() const { return m_views; }
    /// Its keys act with the focus in a plot.
    void addKeys(QAction* action);
    [[nodiscard]] QString csv(const PlotView& view) const;
    /// Whatever the name's ending. What went wrong is told to the session.
    bool exportTo(PlotView& view, const QString& file, PlotFormat format);
    /// Asks for the file; false where the user cancels, too.
    bool askAndExport(PlotView& view, PlotFormat format);

protected:
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void refresh();
    [[nodiscard]] bool useTimes(const Frame* frame);
    [[nodiscard]] PlotInput input() const;
    void addView(const PlotSpec& spec, bool shown);
    void setTexts();
    void openMenu(PlotView& view, const QPoint& position);

    Session& m_session;
    PlotHistory m_history;
    ParameterTrace m_trace;
    std::shared_ptr<const Program> m_program;    ///< of m_history
    std::shared_ptr<const MachineTimes> m_times; ///< of the program of m_history; null: not known yet
    std::uint64_t m_generation = 0;              ///< of the frame that m_history was updated with
    QToolBar* m_bar;
    PlotGrid* m_grid;
    QAction* m_follow;
    std::vector<PlotView*> m_views;
    std::vector<QAction*> m_shown; ///< one a view
    std::size_t m_block = 0;
    std::size_t m_blockCount = 0;
};

} // namespace proveout
