// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QScrollArea>

#include "ui/plots/plot_view.h"

namespace proveout {

/// Plots in rows, with as many per row as remain readable; scrolls if the rows do not fit. Thread: UI.
class PlotGrid : public QScrollArea {
    Q_OBJECT

public:
    static constexpr int kLeastWidth = 320; ///< of a plot, px
    static constexpr int kLeastHeight = 130;

    explicit PlotGrid(QWidget* parent = nullptr);

    /// Takes ownership of the plot.
    void add(PlotView* plot);
    /// Hidden plots use no space.
    void setShown(PlotView& plot, bool shown);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void arrange();

    QWidget* m_inner;
    std::vector<PlotView*> m_plots;
};

} // namespace proveout
