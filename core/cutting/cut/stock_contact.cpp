// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/cut/stock_contact.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>

#include "core/cutting/cut/sweep.h"
#include "core/cutting/rows/touch_path.h"

namespace proveout {

namespace {

constexpr double kNothing = -std::numeric_limits<double>::infinity();

/// Points of contact nearer together than this along the path count as one: two exact cuts may differ by
/// more.
constexpr double kAlike = 2.5e-4;
constexpr double kWidestCell = 1;   ///< mm; the search begins with cells of this size
constexpr double kFineCell = 0.004; ///< smaller ones are not divided
constexpr double kFinest = 1e-5;    ///< mm between the points of the last step
constexpr std::size_t kParts = 4;   ///< a cell is divided into this many rows and columns
constexpr std::size_t kCells = kParts * kParts;
constexpr auto kFiner = static_cast<double>(kParts);

/// The exact stock within a box in plan.
class ExactStock {
public:
    ExactStock(const StockBox& stock, const StockTop* uncut, const std::vector<PastCut>& cuts)
        : m_stock(stock), m_uncut(uncut) {
        m_sweeps.reserve(cuts.size());
        for (const PastCut& cut : cuts)
            m_sweeps.emplace_back(*cut.cutter, cut.motion, stock.topZ());
    }

    /// kNothing if no material is left.
    [[nodiscard]] double height(const Vec2& place) const {
        double height = m_uncut == nullptr ? 0 : m_uncut->height(place);
        for (const Sweep& sweep : m_sweeps)
            height = std::min(height, sweep.envelope(place.x, place.y));
        return absolute(height);
    }

    /// Divides a box in plan into kParts × kParts cells, row by row, and returns an upper bound of the stock
    /// in each. The envelope of a straight motion is convex, so that it is highest at a corner; that of an
    /// arc is nearly so in a cell much smaller than the cutter.
    [[nodiscard]] std::array<double, kCells> highest(const Vec2& corner, double size, double enough) const {
        constexpr std::size_t kCorners = kParts + 1;
        std::array<double, kCells> highest = uncut(corner, size);
        std::array<double, kCorners * kCorners> at{};
        for (const Sweep& sweep : m_sweeps) {
            for (std::size_t k = 0; k < at.size(); ++k) {
                const std::size_t row = k / kCorners;
                const std::size_t column = k % kCorners;
                at[k] = sweep.envelope(corner.x + size * static_cast<double>(column),
                                       corner.y + size * static_cast<double>(row));
            }
            for (std::size_t cell = 0; cell < kCells; ++cell) {
                const std::size_t k = cell / kParts * kCorners + cell % kParts;
                highest[cell] = std::min(
                    highest[cell], std::max({at[k], at[k + 1], at[k + kCorners], at[k + kCorners + 1]}));
            }
            if (absolute(*std::ranges::max_element(highest)) < enough)
                break;
        }
        for (double& height : highest)
            height = absolute(height);
        return highest;
    }

private:
    [[nodiscard]] std::array<double, kCells> uncut(const Vec2& corner, double size) const {
        std::array<double, kCells> highest{};
        for (std::size_t cell = 0; m_uncut != nullptr && cell < kCells; ++cell) {
            const Vec2 lo = corner + size * Vec2(cell % kParts, cell / kParts);
            highest[cell] = m_uncut->highest(lo, lo + size);
        }
        return highest;
    }

    [[nodiscard]] double absolute(double height) const {
        constexpr double kFloor = 1e-6;
        return height > kFloor - m_stock.height ? m_stock.topZ() + height : kNothing;
    }

    const StockBox& m_stock;
    const StockTop* m_uncut;
    std::vector<Sweep> m_sweeps;
};

/// One search for the first touch: cells in plan are divided in the order in which they may be touched, as
/// long as that may be before the earliest touch found; then the neighbourhood of the best point is searched
/// ever more finely.
class Search {
public:
    Search(const StockBox& box, const StockTop* uncut, const CutsWithin& cuts, const std::stop_token& stop,
           const Cutter& cutter, const Vec3& start, const Vec3& end)
        : m_box(box), m_uncut(uncut), m_near(box.corner),
          m_far(box.corner.x + box.width, box.corner.y + box.depth), m_cuts(cuts), m_stop(stop),
          m_path(cutter, start, end), m_lowest(m_path.lowest()),
          m_alike(m_path.length() > 0 ? kAlike / m_path.length() : 0) {
        for (double size = kWidestCell; m_levels.empty() || m_levels.back().size > kFineCell; size /= kFiner)
            m_levels.push_back({size, TouchPath(cutter, start, end, size * std::numbers::sqrt2 / 2)});
    }

    [[nodiscard]] double run() {
        scan();
        while (!m_cells.empty() && !m_stop.stop_requested()) {
            const Cell cell = m_cells.top();
            m_cells.pop();
            if (cell.time >= m_best - m_alike)
                break;
            if (cell.level + 1 < m_levels.size())
                divide(cell);
        }
        if (m_best < TouchPath::kNever && m_best > 0)
            closeIn();
        return m_best;
    }

private:
    struct Level {
        double size;     ///< of a cell
        TouchPath early; ///< of a cutter enlarged so that it reaches all of a cell from its middle
    };
    struct Cell {
        double time; ///< not later than the true one
        std::size_t level;
        Vec2 middle;
        bool operator<(const Cell& other) const { return time > other.time; }
    };

    /// Collects all cells under the path, as if nothing had been cut.
    void scan() {
        if (m_box.topZ() < m_lowest)
            return;
        const TouchPath& early = m_levels.front().early;
        const auto cells = [](const Span& span, double from, double length) {
            const int count = static_cast<int>(std::ceil(length / kWidestCell));
            return columnsUnder({span.lo - kWidestCell / 2, span.hi + kWidestCell / 2},
                                {from + kWidestCell / 2, kWidestCell, 0, count});
        };
        const auto middle = [](double from, int k) { return from + kWidestCell * (k + 0.5); };
        const Columns rows = cells(early.rows(), m_near.y, m_box.depth);
        for (int j = rows.begin; j < rows.end; ++j) {
            const double y = middle(m_near.y, j);
            const Columns columns = cells(early.rowSpan(y), m_near.x, m_box.width);
            for (int i = columns.begin; i < columns.end; ++i)
                add(0, {middle(m_near.x, i), y}, m_box.topZ());
        }
    }

    void add(std::size_t level, const Vec2& middle, double highest) {
        const double early = m_levels[level].early.firstTouch(middle, highest);
        if (early < m_best - m_alike)
            m_cells.push({early, level, middle});
    }

    void consider(const Vec2& place, double height) {
        if (height == kNothing)
            return;
        const double time = m_path.firstTouch(place, height);
        if (time < m_best) {
            m_best = time;
            m_place = place;
        }
    }

    /// Evaluates the middles of the cell's parts, and bounds what each part may hold.
    void divide(const Cell& cell) {
        const std::size_t level = cell.level + 1;
        const double size = m_levels[level].size;
        const Vec2 corner = cell.middle - Vec2(size * kFiner / 2);
        const ExactStock stock(m_box, m_uncut, m_cuts(corner, corner + Vec2(size * kFiner)));
        const auto highest = stock.highest(corner, size, m_lowest);
        for (std::size_t k = 0; k < kCells; ++k) {
            const std::size_t row = k / kParts;
            const std::size_t column = k % kParts;
            const Vec2 part(static_cast<double>(column), static_cast<double>(row));
            const Vec2 from = corner + size * part;
            // There is no material outside the stock.
            if (highest[k] < m_lowest || glm::any(glm::greaterThan(from, m_far)) ||
                glm::any(glm::lessThan(from + size, m_near)))
                continue;
            add(level, from + size / 2, highest[k]);
            const Vec2 middle = glm::clamp(from + size / 2, m_near, m_far);
            consider(middle, stock.height(middle));
        }
    }

    /// Evaluates (2n + 1)² points around the best one.
    void lookAbout(double step, int n) {
        const Vec2 middle = m_place;
        const ExactStock stock(m_box, m_uncut, m_cuts(middle - step * n, middle + step * n));
        for (int j = -n; j <= n; ++j)
            for (int i = -n; i <= n; ++i) {
                const Vec2 there = glm::clamp(middle + step * Vec2(i, j), m_near, m_far);
                consider(there, stock.height(there));
            }
    }

    void closeIn() {
        constexpr int kHalf = 4;
        constexpr int kMostMoves = 16;
        for (double step = m_levels.back().size; step > kFinest; step /= kFiner) {
            // Along an edge the best point may be outside the searched neighbourhood.
            for (int move = 0; move < kMostMoves && !m_stop.stop_requested(); ++move) {
                const double before = m_best;
                const Vec2 from = m_place;
                lookAbout(step, kHalf);
                const Vec2 moved = glm::abs(m_place - from);
                if (m_best == before || std::max(moved.x, moved.y) < step * (kHalf - 1))
                    break;
            }
        }
    }

    const StockBox& m_box;
    const StockTop* m_uncut;
    const Vec2 m_near;
    const Vec2 m_far;
    const CutsWithin& m_cuts;
    const std::stop_token& m_stop;
    const TouchPath m_path;
    const double m_lowest;
    const double m_alike; ///< as a fraction of the path
    std::vector<Level> m_levels;
    std::priority_queue<Cell> m_cells; ///< the earliest one on top
    double m_best = TouchPath::kNever;
    Vec2 m_place{0};
};

} // namespace

std::optional<double> StockContact::firstTouch(const Cutter& cutter, const Vec3& start,
                                               const Vec3& end) const {
    const double time = Search(m_stock, m_uncut, m_cuts, m_stop, cutter, start, end).run();
    if (time == TouchPath::kNever || m_stop.stop_requested())
        return {};
    return time;
}

std::optional<double> StockContact::firstFree(const Cutter& cutter, const Vec3& start,
                                              const Vec3& end) const {
    constexpr double kStep = 0.25; // mm
    const TouchPath path(cutter, start, end);
    if (path.length() == 0)
        return {};
    // Seen from a free position, contact is lost where the reversed path would first touch.
    for (double from = 0; from < 1 && !m_stop.stop_requested();) {
        const double to = std::min(1.0, from + kStep / path.length());
        const auto back = firstTouch(cutter, path.at(to), path.at(from));
        if (!back)
            return m_stop.stop_requested() ? std::nullopt : std::optional(from);
        const double free = *back * (to - from);
        if (free * path.length() > kAlike)
            return to - free;
        from = to;
    }
    return {};
}

} // namespace proveout
