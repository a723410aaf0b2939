// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <qcustomplot.h>

#include "ui/plots/plot_catalogue.h"
#include "ui/plots/plot_header.h"
#include "ui/plots/plot_hint.h"
#include "ui/plots/plot_ticks.h"
#include "ui/plots/row_curve.h"
#include "ui/plots/row_range.h"

class QScrollBar;

namespace proveout {

/// A plot of the catalogue. Thread: UI. Data is appended row by row; setBlock() schedules a repaint.
class PlotView : public QCustomPlot {
    Q_OBJECT

public:
    explicit PlotView(const PlotSpec& spec, QWidget* parent = nullptr);

    [[nodiscard]] const PlotSpec& spec() const { return m_spec; }
    /// Takes the rows `changed` of `input`, of which the first is at most rows(), and drops those that are no
    /// longer in `input`.
    void setRows(const PlotInput& input, RowRange changed);
    /// Takes all rows of `input` from `first` on.
    void setRows(const PlotInput& input, std::size_t first) { setRows(input, {first, input.blocks.size()}); }
    /// Sets the blocks at which setBlock() will draw a dashed line.
    void setParameterChanges(const std::vector<std::size_t>& blocks);
    /// Marks the current block, scrolls the axes if they follow, and repaints.
    void setBlock(std::size_t block, std::size_t blockCount);

    [[nodiscard]] bool following() const { return m_following; }
    void setFollowing(bool following);
    [[nodiscard]] PlotHint& hint() { return m_hint; }
    /// Shows all blocks and follows the current one.
    void showAll();

    /// The text about the row nearest to a pixel; empty if there is none.
    [[nodiscard]] QString valuesAt(double pixelX) const;
    /// The value of one curve in a row, as drawn (stacked plots: without the curves below).
    [[nodiscard]] double value(std::size_t series, std::size_t row) const;
    [[nodiscard]] std::size_t rows() const { return m_curves.front()->rows(); }
    /// In a scroll area the wheel moves its bar, and zooms only with Ctrl pressed; null outside of one. (The
    /// base class does not pass mouse events to its parents.)
    void setScrollBar(QScrollBar* bar) { m_scrollBar = bar; }

    [[nodiscard]] QByteArray png(double scale);
    [[nodiscard]] QByteArray svg();

signals:
    void blockClicked(std::size_t block);
    void followingChanged(bool following);

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void addCurves();
    void style();
    void styleCurves();
    void styleMark();
    void setTexts();
    void fitAxes();
    void fitValues();
    void fitTicks();
    [[nodiscard]] QCPGraphDataContainer::const_iterator pointOf(std::size_t series, std::size_t row) const;
    /// The range of the visible values above 0; empty if there are none.
    [[nodiscard]] std::optional<QCPRange> valuesInSight() const;
    void setLogarithmic(bool on);
    [[nodiscard]] QString pictureText(std::size_t row) const;
    [[nodiscard]] std::size_t rowAt(double block) const;
    /// If several rows of blocks share a pixel: the highest of them, because that one is visible.
    [[nodiscard]] std::optional<std::size_t> peakAt(double pixelX) const;
    void styleChanges();

    const PlotSpec& m_spec;
    PlotHeader m_header;
    std::vector<RowCurve*> m_curves; ///< one per series; owned by the plot
    QSharedPointer<PlotTicks> m_blockTicks;
    QSharedPointer<PlotTicks> m_valueTicks;
    std::vector<PictureBlocks> m_pictures; ///< one per row, if the plot uses them
    QCPItemStraightLine* m_mark;
    PlotHint m_hint;
    std::vector<QCPItemStraightLine*> m_changes; ///< owned by the plot
    std::size_t m_block = 0;
    std::size_t m_blockCount = 0;
    bool m_following = true;
    double m_span = 0; ///< number of blocks shown; 0: all
    bool m_dragged = false;
    QScrollBar* m_scrollBar = nullptr; ///< not owned
    QPointF m_pressed;
};

} // namespace proveout
