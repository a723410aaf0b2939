// SPDX-License-Identifier: GPL-3.0-or-later
// An extruded outline: its crossings with a horizontal line give the parts of the line that are inside.
#include "core/zmap/extruded_stock.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "core/base/figures_argument.h"
#include "core/zmap/grid_part.h"
#include "core/zmap/outline_crossing.h"
#include "core/zmap/zmap_findings.h"

namespace proveout {

namespace {

/// A point this near to the outline, in mm, counts as on it: coordinates of a grid are rounded.
constexpr double kOnOutline = 1e-6;
constexpr double kFarthest = 1e7;
/// A flatter arc is treated as a line: its centre would be lost in rounding.
constexpr double kFlat = 1e-7;

struct Span {
    double from, to;
};

class Outline {
public:
    void add(const OutlineLoop& loop) {
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const OutlinePoint& from = loop[k];
            const Vec2 to = loop[(k + 1) % loop.size()].at;
            if (std::abs(from.bulge) < kFlat || from.at == to)
                addPiece({from.at, to});
            else
                addArc(from, to);
        }
    }

    [[nodiscard]] const Vec2& lo() const { return m_lo; }
    [[nodiscard]] const Vec2& hi() const { return m_hi; }
    [[nodiscard]] const std::vector<OutlinePiece>& pieces() const { return m_pieces; }
    [[nodiscard]] bool hasArea() const { return m_lo.x < m_hi.x && m_lo.y < m_hi.y; }

    /// The parts of a horizontal line that are within the outline, including the outline itself; ascending.
    [[nodiscard]] std::vector<Span> spansAt(double y) const {
        // The line itself neither crosses a horizontal side nor detects it; a line just above or below does.
        std::vector<Span> spans = crossed(y - kOnOutline);
        const std::vector<Span> above = crossed(y + kOnOutline);
        spans.insert(spans.end(), above.begin(), above.end());
        std::ranges::sort(spans, {}, &Span::from);
        std::vector<Span> merged;
        for (const Span& span : spans) {
            if (!merged.empty() && span.from <= merged.back().to)
                merged.back().to = std::max(merged.back().to, span.to);
            else
                merged.push_back(span);
        }
        return merged;
    }

    [[nodiscard]] bool holds(const Vec2& place) const {
        const std::vector<Span> spans = spansAt(place.y);
        return std::ranges::any_of(
            spans, [&](const Span& span) { return place.x >= span.from && place.x <= span.to; });
    }

    [[nodiscard]] double distance(const Vec2& place) const {
        double least = kFarthest;
        for (const OutlinePiece& piece : m_pieces)
            least = std::min(least, piece.distance(place));
        return least;
    }

private:
    void add(const Vec2& place) {
        m_lo = glm::min(m_lo, place);
        m_hi = glm::max(m_hi, place);
    }

    void addPiece(OutlinePiece piece) {
        add(piece.low);
        add(piece.high);
        if (piece.low.y > piece.high.y)
            std::swap(piece.low, piece.high);
        m_pieces.push_back(piece);
    }

    /// The arc is split at its lowest and highest points and at its sides, so that the parts meet exactly.
    void addArc(const OutlinePoint& from, const Vec2& to) {
        constexpr double kQuarter = std::numbers::pi / 2;
        const Vec2 chord = to - from.at;
        const double b = from.bulge;
        const Vec2 centre = from.at + chord / 2.0 + Vec2(-chord.y, chord.x) * ((1 - b * b) / (4 * b));
        const double radius = glm::distance(from.at, centre);
        const double begin = std::atan2(from.at.y - centre.y, from.at.x - centre.x);
        const double end = begin + 4 * std::atan(b);
        std::vector<double> quarters;
        for (double k = std::floor(std::min(begin, end) / kQuarter) + 1; k * kQuarter < std::max(begin, end);
             ++k)
            quarters.push_back(k);
        if (b < 0)
            std::ranges::reverse(quarters);
        Vec2 last = from.at;
        double lastAngle = begin;
        const auto goTo = [&](const Vec2& place, double angle) {
            const double side = std::cos((lastAngle + angle) / 2) < 0 ? -1 : 1;
            addPiece({last, place, centre, radius, side});
            last = place;
            lastAngle = angle;
        };
        for (const double k : quarters) {
            const auto quarter = static_cast<int>(k) & 3;
            const Vec2 away = quarter % 2 == 0 ? Vec2(1.0 - quarter, 0) : Vec2(0, 2.0 - quarter);
            goTo(centre + radius * away, k * kQuarter);
        }
        goTo(to, end);
    }

    [[nodiscard]] std::vector<Span> crossed(double y) const {
        std::vector<double> at;
        for (const OutlinePiece& piece : m_pieces)
            if (piece.crosses(y))
                at.push_back(piece.crossing(y));
        std::ranges::sort(at);
        std::vector<Span> spans;
        for (std::size_t k = 0; k + 1 < at.size(); k += 2)
            spans.push_back({at[k] - kOnOutline, at[k + 1] + kOnOutline});
        return spans;
    }

    std::vector<OutlinePiece> m_pieces;
    Vec2 m_lo{kFarthest};
    Vec2 m_hi{-kFarthest};
};

class ExtrudedTop final : public StockTop {
public:
    ExtrudedTop(const Outline& outline, const Vec2& offset) : m_outline(outline), m_offset(offset) {}

    [[nodiscard]] double height(const Vec2& place) const override {
        return m_outline.holds(place - m_offset) ? 0 : kAbsent;
    }
    [[nodiscard]] double highest(const Vec2& lo, const Vec2& hi) const override {
        const Vec2 middle = (lo + hi) / 2.0 - m_offset;
        const bool outside =
            m_outline.distance(middle) > glm::distance(lo, hi) / 2 + kOnOutline && !m_outline.holds(middle);
        return outside ? kAbsent : 0;
    }

private:
    const Outline& m_outline; ///< of the body, which the setup holds
    Vec2 m_offset;
};

class ExtrudedStock final : public StockBody, public PartedStock {
public:
    ExtrudedStock(Outline outline, double height, double topZ)
        : m_outline(std::move(outline)), m_height(height), m_topZ(topZ) {}

    [[nodiscard]] StockBox box() const override {
        const Vec2 size = m_outline.hi() - m_outline.lo();
        return {{m_outline.lo(), m_topZ}, size.x, size.y, m_height};
    }
    [[nodiscard]] UncutStock uncut(const StockBox& stock, const Grid& grid) const override {
        UncutStock uncut{ZMap(stock, grid), {}};
        removeOutside(uncut.zmap, stock, GridPart(grid));
        return uncut;
    }
    [[nodiscard]] ZMap uncutPart(const StockBox& stock, const GridPart& part) const override {
        ZMap zmap(part.stock(stock), part.grid());
        removeOutside(zmap, stock, part);
        return zmap;
    }
    [[nodiscard]] std::unique_ptr<StockTop> top(const StockBox& stock) const override {
        return std::make_unique<ExtrudedTop>(m_outline, offsetTo(stock));
    }

private:
    [[nodiscard]] Vec2 offsetTo(const StockBox& stock) const { return Vec2(stock.corner) - m_outline.lo(); }

    void removeOutside(ZMap& zmap, const StockBox& stock, const GridPart& grid) const {
        const Vec2 offset = offsetTo(stock);
        std::vector<bool> within(static_cast<std::size_t>(grid.nx));
        for (int j = 0; j < grid.ny; ++j) {
            markWithin(grid, j, offset, within);
            for (int i = 0; i < grid.nx; ++i)
                if (!within[static_cast<std::size_t>(i)])
                    removePoint(zmap, i, j);
        }
        for (std::size_t index = 0; index < zmap.tileCount(); ++index)
            zmap.tileForWriting(index).refreshMaximum();
    }

    void markWithin(const GridPart& grid, int j, const Vec2& offset, std::vector<bool>& within) const {
        within.assign(within.size(), false);
        for (const Span& span : m_outline.spansAt(grid.y(j) - offset.y)) {
            const double first = std::ceil((span.from + offset.x - grid.origin.x) / grid.hx) - grid.firstI;
            const double last = std::floor((span.to + offset.x - grid.origin.x) / grid.hx) - grid.firstI;
            const auto from = static_cast<std::ptrdiff_t>(std::clamp(first, 0.0, double(grid.nx)));
            const auto to = static_cast<std::ptrdiff_t>(std::clamp(last + 1, double(from), double(grid.nx)));
            std::fill(within.begin() + from, within.begin() + to, true);
        }
    }

    static void removePoint(ZMap& zmap, int i, int j) {
        const auto tile = static_cast<std::size_t>((j / Tile::kSize) * zmap.tilesX() + i / Tile::kSize);
        zmap.tileForWriting(tile).at(i % Tile::kSize, j % Tile::kSize) = zmap.floor();
    }

    Outline m_outline;
    double m_height;
    double m_topZ;
};

bool isReasonable(const OutlinePoint& point) {
    constexpr double kLargestBulge = 1e3; // an arc that is less than a quarter of a degree short of a full
                                          // circle
    return std::abs(point.at.x) <= kFarthest && std::abs(point.at.y) <= kFarthest &&
           std::abs(point.bulge) <= kLargestBulge;
}

} // namespace

Result<std::shared_ptr<const StockBody>> extrudedStock(const std::vector<OutlineLoop>& loops, double height,
                                                       double topZ) {
    Outline outline;
    for (const OutlineLoop& loop : loops) {
        if (!std::ranges::all_of(loop, isReasonable))
            return failure(zmap_finding::kOutlineOutOfRange, {"10000000"});
        outline.add(loop);
    }
    if (!outline.hasArea())
        return failure(zmap_finding::kOutlineWithoutArea);
    if (const auto place = crossingOf(outline.pieces()))
        return failure(zmap_finding::kOutlineCrossesItself,
                       {figures("{:.3f}", place->x), figures("{:.3f}", place->y)});
    return std::make_shared<const ExtrudedStock>(std::move(outline), height, topZ);
}

OutlineLoop circleOutline(double diameter) {
    return {{{0, diameter / 2}, 1}, {{diameter, diameter / 2}, 1}};
}

} // namespace proveout
