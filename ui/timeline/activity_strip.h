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

/// The activity in a program as an image with one pixel column per range of blocks: cutting at the bottom,
/// air cuts above it, rapids on top, each as high as its share of the time. Every activity in a column gets
/// at least one row, and a rapid through material fills the column, so that neither gets lost among thousands
/// of blocks on one pixel. Blocks that were not simulated yet are empty. The image is kept, and an update
/// draws only new columns.
class ActivityStrip {
public:
    /// Rapids are dotted above their lowest row, so that nothing depends on hue alone.
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
    /// The blocks of a column: one if there are fewer blocks than columns, otherwise every block belongs to
    /// exactly one column. `blocks` > 0.
    [[nodiscard]] static Stretch blocksOf(int column, int columns, std::size_t blocks);
    /// Rows of a column by Activity; their sum is `height`, or 0 if nothing is known. `height` >= 3.
    [[nodiscard]] static std::array<int, kActivities> rowsOf(const ActivitySums& sums, int height);

    /// Sets size in pixels, number of blocks and colours; if they change, the image is cleared.
    void fit(QSize size, std::size_t blocks, const Colors& colors);
    /// Draws what is new in the log, or everything if older entries have changed. Returns the number of
    /// columns drawn.
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
