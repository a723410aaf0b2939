// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <qcustomplot.h>

#include "ui/plots/plot_catalogue.h"
#include "ui/plots/plot_header.h"
#include "ui/plots/plot_ticks.h"

class QScrollBar;

namespace proveout {

/// One plot of the catalogue. Thread: UI. Data is appended row by row; setBlock() repaints at the next
/// chance.
class PlotView : public QCustomPlot {
    Q_OBJECT

public:
    explicit PlotView(const PlotSpec& spec, QWidget* parent = nullptr);

    [[nodiscard]] const PlotSpec& spec() const { return m_spec; }
    /// Drops the rows from `first` on and takes those of `input` in their place.
    void setRows(const PlotInput& input, std::size_t first);
    /// Draws a dashed line at each of these blocks, at the next setBlock().
    void setParameterChanges(const std::vector<std::size_t>& blocks);
    /// Marks the current block, moves the axes where they follow, and repaints.
    void setBlock(std::size_t block, std::size_t blockCount);

    [[nodiscard]] bool following() const { return m_following; }
    void setFollowing(bool following);
    /// All blocks, following.
    void showAll();

    /// What is told about the row nearest to a pixel; empty where there is none.
    [[nodiscard]] QString valuesAt(double pixelX) const;
    /// The value of one curve at a row, as drawn (stacked plots: without those below).
    [[nodiscard]] double value(std::size_t series, std::size_t row) const;
    [[nodiscard]] std::size_t rows() const { return rows(0); }
    /// Where it stands in an area that scrolls, the wheel moves its bar, and zooms with Ctrl held down; null
    /// elsewhere. (The base class keeps mouse events from its parents.)
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
    [[nodiscard]] std::size_t rows(std::size_t series) const;
    [[nodiscard]] QCPGraphDataContainer::const_iterator pointOf(std::size_t series, std::size_t row) const;
    /// Of the points in sight those above 0; empty where there are none.
    [[nodiscard]] std::optional<QCPRange> valuesInSight() const;
    void setLogarithmic(bool on);
    [[nodiscard]] QString pictureText(std::size_t row) const;
    [[nodiscard]] std::size_t rowAt(double block) const;
    /// Where several rows of blocks stand on one pixel: the highest of them, which is the one that is seen.
    [[nodiscard]] std::optional<std::size_t> peakAt(double pixelX) const;
    void styleChanges();

    const PlotSpec& m_spec;
    PlotHeader m_header;
    QSharedPointer<PlotTicks> m_blockTicks;
    QSharedPointer<PlotTicks> m_valueTicks;
    std::vector<PictureBlocks> m_pictures; ///< of the rows, where the plot has them
    QCPItemStraightLine* m_mark;
    QCPItemText* m_hint;                         ///< in place of curves, before there is anything to show
    std::vector<QCPItemStraightLine*> m_changes; ///< owned by the plot
    std::size_t m_block = 0;
    std::size_t m_blockCount = 0;
    bool m_following = true;
    double m_span = 0; ///< blocks shown; 0: all
    bool m_dragged = false;
    QScrollBar* m_scrollBar = nullptr; ///< not owned
    QPointF m_pressed;
};

} // namespace proveout
