// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <QColor>
#include <QImage>
#include <QPalette>
#include <QSize>

#include "core/simulation/records/activity_log.h"

namespace proveout {

/// What a program does as a picture, a column a pixel over all its blocks: cutting from below, air on it,
/// rapids on top, each as high as its share of the time. Whatever occurs in a column has a row of it at
/// least, and a rapid through stock has the whole column: neither is lost among thousands of blocks on one
/// pixel. What was not simulated yet is empty. Kept between updates, which draw the columns that are new.
class ActivityStrip {
public:
    /// Rapids are dotted with theirs above their lowest row, so that no kind is told by hue alone.
    struct Colors {
        QColor cutting;
        QColor air;
        QColor rapid;
        QColor rapidInStock;

        friend bool operator==(const Colors&, const Colors&) = default;
    };
    [[nodiscard]] static Colors colors(const QPalette& palette);

    /// The blocks [first, last).
    struct Stretch {
        std::size_t first = 0;
        std::size_t last = 0;
    };
    /// Those that a column stands for: one where there are fewer blocks than columns; else every block
    /// stands in exactly one of them. `blocks` > 0.
    [[nodiscard]] static Stretch blocksOf(int column, int columns, std::size_t blocks);
    /// Rows of a column by Activity; their sum is `height`, or 0 where nothing is known. `height` >= 3.
    [[nodiscard]] static std::array<int, kActivities> rowsOf(const ActivitySums& sums, int height);

    /// Takes another size in pixels, number of blocks or colours: the picture is then empty.
    void fit(QSize size, std::size_t blocks, const Colors& colors);
    /// Draws what is new in the log, or all where it tells otherwise than before. Returns how many columns.
    int update(const ActivityLog& log);
    [[nodiscard]] const QImage& image() const { return m_image; }

private:
    void drawColumn(int column, const ActivitySums& sums);

    QImage m_image;
    std::size_t m_blocks = 0;
    Colors m_colors;
    std::size_t m_drawn = 0; ///< blocks
    std::uint64_t m_revision = 0;
};

} // namespace proveout
