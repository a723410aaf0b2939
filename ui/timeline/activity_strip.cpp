// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/timeline/activity_strip.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "ui/look/theme.h"

namespace proveout {

namespace {

std::size_t place(Activity activity) {
    return static_cast<std::size_t>(activity);
}

/// From bottom to top.
constexpr std::array kOrder{Activity::cutting, Activity::air, Activity::rapid, Activity::rapidInStock};

} // namespace

ActivityStrip::Colors ActivityStrip::colors(const QPalette& palette) {
    const MeaningColors meaning = meaningColors(palette);
    return {meaning.cutting, meaning.air, palette.color(QPalette::PlaceholderText), meaning.error};
}

ActivityStrip::Stretch ActivityStrip::blocksOf(int column, int columns, std::size_t blocks) {
    const auto begin = [&](int of) {
        return static_cast<std::size_t>(of) * blocks / static_cast<std::size_t>(columns);
    };
    const std::size_t first = begin(column);
    return {first, std::max(first + 1, begin(column + 1))};
}

std::array<int, kActivities> ActivityStrip::rowsOf(const ActivitySums& sums, int height) {
    std::array<int, kActivities> rows{};
    if (sums.empty())
        return rows;
    if (sums.has(Activity::rapidInStock)) {
        rows[place(Activity::rapidInStock)] = height;
        return rows;
    }
    for (const Activity activity : kOrder) {
        if (sums.has(activity))
            rows[place(activity)] = std::max(1, static_cast<int>(std::lround(sums.share(activity) * height)));
    }
    // The largest part gets the difference, so that the sum is right.
    *std::ranges::max_element(rows) += height - std::accumulate(rows.begin(), rows.end(), 0);
    return rows;
}

void ActivityStrip::fit(QSize size, std::size_t blocks, const Colors& colors) {
    if (size == m_image.size() && blocks == m_blocks && colors == m_colors)
        return;
    m_image = QImage(size, QImage::Format_ARGB32_Premultiplied);
    m_image.fill(Qt::transparent);
    m_blocks = blocks;
    m_colors = colors;
    m_drawn = 0;
}

int ActivityStrip::update(const ActivityLog& log) {
    if (log.revision() != m_revision) {
        m_image.fill(Qt::transparent);
        m_drawn = 0;
        m_revision = log.revision();
    }
    const std::size_t known = std::min(log.size(), m_blocks);
    if (m_drawn >= known)
        return 0;
    // The column of the first new block may also contain older blocks, so it is drawn again.
    const auto columns = static_cast<std::size_t>(m_image.width());
    const auto first = static_cast<int>(m_drawn * columns / m_blocks);
    const auto last = static_cast<int>((known * columns + m_blocks - 1) / m_blocks);
    for (int column = first; column < last; ++column) {
        const Stretch stretch = blocksOf(column, m_image.width(), m_blocks);
        drawColumn(column, log.sums(stretch.first, stretch.last));
    }
    m_drawn = known;
    return last - first;
}

void ActivityStrip::drawColumn(int column, const ActivitySums& sums) {
    const std::array colors{m_colors.rapid.rgba(), m_colors.air.rgba(), m_colors.cutting.rgba(),
                            m_colors.rapidInStock.rgba()}; // same order as Activity
    const auto rows = rowsOf(sums, m_image.height());
    int y = m_image.height();
    for (const Activity activity : kOrder) {
        for (int row = 0; row < rows[place(activity)]; ++row) {
            --y;
            const bool gap = activity == Activity::rapid && row > 0 && (column + y) % 2 != 0;
            m_image.setPixel(column, y, gap ? 0U : colors[place(activity)]);
        }
    }
}

} // namespace proveout
