// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/row_extremes.h"

#include <algorithm>

namespace proveout {

namespace {

constexpr std::size_t kGroup = 16; ///< elements that one of the next level stands for

std::size_t groupsOf(std::size_t elements) {
    return (elements + kGroup - 1) / kGroup;
}

double valueOf(const QCPGraphData& row) {
    return row.value;
}

const Extremes& valueOf(const Extremes& extremes) {
    return extremes;
}

template<class Elements>
void addAll(Extremes& sum, const Elements& elements, std::size_t first, std::size_t end) {
    for (std::size_t at = first; at < end; ++at)
        sum.add(valueOf(elements[at]));
}

/// Adds those of [first, end) that do not fill a group, and leaves the groups between them.
template<class Elements>
void addEnds(Extremes& sum, const Elements& elements, std::size_t& first, std::size_t& end) {
    const std::size_t whole = std::min(end, groupsOf(first) * kGroup);
    addAll(sum, elements, first, whole);
    first = whole;
    const std::size_t wholeEnd = std::max(first, end / kGroup * kGroup);
    addAll(sum, elements, wholeEnd, end);
    end = wholeEnd;
}

template<class Elements>
void updateLevel(std::vector<Extremes>& level, const Elements& elements, std::size_t first, std::size_t end) {
    level.resize(groupsOf(elements.size()));
    for (std::size_t group = first / kGroup; group < std::min(level.size(), groupsOf(end)); ++group) {
        level[group] = {};
        addAll(level[group], elements, group * kGroup, std::min(elements.size(), (group + 1) * kGroup));
    }
}

} // namespace

void Extremes::add(double value) {
    if (std::isnan(value))
        return;
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
    if (value > 0)
        lowestAbove0 = std::min(lowestAbove0, value);
}

void Extremes::add(const Extremes& other) {
    lowest = std::min(lowest, other.lowest);
    highest = std::max(highest, other.highest);
    lowestAbove0 = std::min(lowestAbove0, other.lowestAbove0);
}

void RowExtremes::update(Rows rows, std::size_t first, std::size_t end) {
    // If rows were dropped, the group of the last one has changed.
    first = std::min(first, rows.empty() ? 0 : rows.size() - 1);
    end = std::max(end, first + 1);
    if (m_levels.empty())
        m_levels.emplace_back();
    updateLevel(m_levels.front(), rows, first, end);
    std::size_t level = 0;
    for (; m_levels[level].size() > kGroup; ++level) {
        first /= kGroup;
        end = groupsOf(end);
        if (level + 1 == m_levels.size()) {
            m_levels.emplace_back();
            first = 0; // A new level also needs the groups before the changed rows.
        }
        updateLevel(m_levels[level + 1], m_levels[level], first, end);
    }
    m_levels.resize(level + 1);
}

Extremes RowExtremes::of(Rows rows, std::size_t first, std::size_t end) const {
    Extremes sum;
    end = std::min(end, rows.size());
    if (first >= end)
        return sum;
    addEnds(sum, rows, first, end);
    for (const auto& level : m_levels) {
        first /= kGroup;
        end /= kGroup;
        if (&level == &m_levels.back())
            addAll(sum, level, first, end);
        else
            addEnds(sum, level, first, end);
    }
    return sum;
}

} // namespace proveout
