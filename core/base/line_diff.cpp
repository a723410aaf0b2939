// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/line_diff.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>

namespace proveout {

namespace {

/// Lines as numbers: equal numbers are equal lines.
using Numbers = std::vector<std::uint32_t>;

/// The furthest places of the greedy search on the diagonals -d … d, one row for each number of edits d.
using Reached = std::vector<std::vector<std::size_t>>;

class Numbering {
public:
    Numbers of(const std::vector<std::string_view>& lines, std::size_t first, std::size_t last) {
        Numbers numbers;
        numbers.reserve(last - first);
        for (std::size_t i = first; i < last; ++i)
            numbers.push_back(
                m_known.try_emplace(lines[i], static_cast<std::uint32_t>(m_known.size())).first->second);
        return numbers;
    }

private:
    std::unordered_map<std::string_view, std::uint32_t> m_known;
};

/// A place on diagonal k = x - y is given by its x; k starts at -d.
class Search {
public:
    Search(const Numbers& before, const Numbers& after) : m_before(before), m_after(after) {}

    /// Nothing if more than `mostEdits` are needed.
    [[nodiscard]] std::optional<Reached> run(std::size_t mostEdits) const {
        Reached reached;
        for (std::size_t d = 0; d <= mostEdits && d <= m_before.size() + m_after.size(); ++d) {
            std::vector<std::size_t>& row = reached.emplace_back(2 * d + 1, 0);
            for (std::size_t i = 0; i <= 2 * d; i += 2) {
                const auto k = static_cast<std::ptrdiff_t>(i) - static_cast<std::ptrdiff_t>(d);
                const std::size_t x = d == 0 ? 0 : start(reached[d - 1], d, i);
                if (isOutside(x, k))
                    continue;
                row[i] = alongEqual(x, k);
                if (row[i] == m_before.size() && row[i] - static_cast<std::size_t>(k) == m_after.size())
                    return reached;
            }
        }
        return std::nullopt;
    }

    /// Whether the step to entry `i` of row `d` inserts a line (moves down) rather than removes one.
    [[nodiscard]] static bool inserts(const std::vector<std::size_t>& previous, std::size_t d,
                                      std::size_t i) {
        // Diagonal k is entry i here, i - 1 in the row before; its neighbours there are i - 2 and i.
        return i == 0 || (i < 2 * d && previous[i - 2] < previous[i]);
    }
    [[nodiscard]] static std::size_t start(const std::vector<std::size_t>& previous, std::size_t d,
                                           std::size_t i) {
        return inserts(previous, d, i) ? previous[i] : previous[i - 2] + 1;
    }

private:
    [[nodiscard]] bool isOutside(std::size_t x, std::ptrdiff_t k) const {
        const std::ptrdiff_t y = static_cast<std::ptrdiff_t>(x) - k;
        return x > m_before.size() || y < 0 || y > static_cast<std::ptrdiff_t>(m_after.size());
    }
    [[nodiscard]] std::size_t alongEqual(std::size_t x, std::ptrdiff_t k) const {
        auto y = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(x) - k);
        while (x < m_before.size() && y < m_after.size() && m_before[x] == m_after[y]) {
            ++x;
            ++y;
        }
        return x;
    }

    const Numbers& m_before;
    const Numbers& m_after;
};

void append(std::vector<LineChange>& reversed, const LineChange& edit) {
    if (!reversed.empty() && reversed.back().beforeFirst == edit.beforeLast &&
        reversed.back().afterFirst == edit.afterLast) {
        reversed.back().beforeFirst = edit.beforeFirst;
        reversed.back().afterFirst = edit.afterFirst;
    } else {
        reversed.push_back(edit);
    }
}

/// The edits from the end back to the beginning, joined where they touch.
std::vector<LineChange> changesOf(const Reached& reached, std::size_t beforeSize, std::size_t afterSize) {
    std::vector<LineChange> reversed;
    std::size_t x = beforeSize;
    std::size_t y = afterSize;
    for (std::size_t d = reached.size() - 1; d > 0; --d) {
        const std::size_t i = x + d - y; // of diagonal x - y
        const std::vector<std::size_t>& previous = reached[d - 1];
        const bool inserts = Search::inserts(previous, d, i);
        const std::size_t fromX = inserts ? previous[i] : previous[i - 2];
        const std::size_t fromY = inserts ? fromX + d - i - 1 : fromX + d + 1 - i;
        append(reversed, inserts ? LineChange{fromX, fromX, fromY, fromY + 1}
                                 : LineChange{fromX, fromX + 1, fromY, fromY});
        x = fromX;
        y = fromY;
    }
    std::reverse(reversed.begin(), reversed.end());
    return reversed;
}

} // namespace

std::vector<LineChange> compareLines(const std::vector<std::string_view>& before,
                                     const std::vector<std::string_view>& after, std::size_t mostEdits) {
    const auto head = static_cast<std::size_t>(
        std::mismatch(before.begin(), before.end(), after.begin(), after.end()).first - before.begin());
    std::size_t tail = 0;
    const std::size_t mostTail = std::min(before.size(), after.size()) - head;
    while (tail < mostTail && before[before.size() - 1 - tail] == after[after.size() - 1 - tail])
        ++tail;
    const LineChange whole{head, before.size() - tail, head, after.size() - tail};
    if (whole.beforeFirst == whole.beforeLast && whole.afterFirst == whole.afterLast)
        return {};
    Numbering numbering;
    const Numbers old = numbering.of(before, head, whole.beforeLast);
    const Numbers now = numbering.of(after, head, whole.afterLast);
    const auto reached = Search(old, now).run(mostEdits);
    if (!reached)
        return {whole};
    std::vector<LineChange> changes = changesOf(*reached, old.size(), now.size());
    for (LineChange& change : changes)
        change = {change.beforeFirst + head, change.beforeLast + head, change.afterFirst + head,
                  change.afterLast + head};
    return changes;
}

} // namespace proveout
