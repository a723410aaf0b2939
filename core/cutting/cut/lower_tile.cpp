// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/cut/lower_tile.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

#include "core/cutting/profiles/vector_clones.h"

namespace proveout {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr int kLanes = 8;
static_assert(Tile::kSize % kLanes == 0);
/// Refreshing a tile's maximum costs about as much as lowering this many points.
constexpr std::uint32_t kRefreshAfter = 1024;
constexpr double kMiddle = (Tile::kSize - 1) / 2.0;

using Row = std::array<float, Tile::kSize>;

/// Sums of one tile, lane by lane: the order of additions is fixed, and the compiler may use vectors.
struct LaneSums {
    std::array<double, kLanes> removed{};
    std::array<float, kLanes> depth{};
    std::array<std::int32_t, kLanes> points{};
};

/// Whether a point would change; points on the floor already cannot.
PROVEOUT_VECTOR_CLONES bool anyLower(const float* envelope, const float* heights, int count, float floor) {
    std::array<int, kLanes> lower{};
    for (int k = 0; k < count; k += kLanes) {
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            const auto at = static_cast<std::size_t>(k) + lane;
            const float cut = envelope[at] < floor ? floor : envelope[at];
            lower[lane] |= cut < heights[at] ? 1 : 0;
        }
    }
    return std::any_of(lower.begin(), lower.end(), [](int value) { return value != 0; });
}

/// Writes the minimum of both into `heights`; `removed` is what each point lost.
PROVEOUT_VECTOR_CLONES void lowerRow(const float* envelope, float* heights, float* removed, int count,
                                     float floor, LaneSums& sums) {
    for (int k = 0; k < count; k += kLanes) {
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            const auto at = static_cast<std::size_t>(k) + lane;
            const float old = heights[at];
            const float cut = envelope[at] < floor ? floor : envelope[at];
            const float now = cut < old ? cut : old;
            const float lost = old - now;
            heights[at] = now;
            removed[at] = lost;
            sums.removed[lane] += static_cast<double>(lost);
            sums.depth[lane] = lost > sums.depth[lane] ? lost : sums.depth[lane];
            sums.points[lane] += lost > 0 ? 1 : 0;
        }
    }
}

double total(const LaneSums& sums) {
    double sum = 0;
    for (const double lane : sums.removed)
        sum += lane;
    return sum;
}

/// The weights of the points of a tile on the border of the map; nothing for other tiles, where all points
/// weigh the same.
std::optional<PointWeights> weightsOf(const Grid& grid, const IndexRect& rect) {
    if (rect.i0 > 0 && rect.j0 > 0 && rect.i0 + Tile::kSize < grid.nx && rect.j0 + Tile::kSize < grid.ny)
        return std::nullopt;
    PointWeights weights;
    for (int k = 0; k < Tile::kSize; ++k) {
        const auto at = static_cast<std::size_t>(k);
        weights.columns[at] = rect.i0 + k == 0 || rect.i0 + k == grid.nx - 1 ? 0.5F : 1.0F;
        weights.rows[at] = rect.j0 + k == 0 || rect.j0 + k == grid.ny - 1 ? 0.5F : 1.0F;
    }
    return weights;
}

/// The work on one tile, sweep by sweep.
class TileWork {
public:
    TileWork(ZMap& zmap, std::size_t index, const GridPart& place, const std::stop_token& stop,
             Provenance::Marks* marks)
        : m_zmap(zmap), m_index(index), m_stop(stop), m_marks(marks), m_grid(zmap.grid()), m_place(place),
          m_spacing(m_grid.hx, m_grid.hy), m_rect(zmap.tileRect(index)), m_floor(zmap.floor()),
          m_weights(weightsOf(m_grid, m_rect)) {
        m_envelope.fill(kInfinity);
    }

    /// After a stop nothing more is lowered.
    CutRecord lower(const PreparedSweep& prepared) {
        m_sums = {};
        m_mark = prepared.mark;
        if (!mayLower(prepared.sweep) || !mayContinue())
            return {};
        if (prepared.passes.empty()) {
            lowerRows(prepared.sweep);
            finishRows();
        } else {
            lowerByPasses(prepared);
        }
        return m_sums.record;
    }

    /// Lowers the tile by all sweeps, in any order.
    void lowerByAll(std::span<const PreparedSweep> sweeps, std::span<const std::uint32_t> order,
                    PassTable& table) {
        table.clear();
        for (const std::uint32_t k : order)
            collect(sweeps[k], table);
        lowerByAll(table);
    }

    /// Lowers the tile by all sweeps: in any order those between two that are recorded.
    void lowerInTurn(std::span<const PreparedSweep> sweeps, std::span<const std::uint32_t> order,
                     std::span<CutRecord> records, PassTable& table) {
        table.clear();
        auto record = records.begin();
        for (const std::uint32_t k : order) {
            const PreparedSweep& prepared = sweeps[k];
            if (!prepared.recorded) {
                collect(prepared, table);
                continue;
            }
            *record = {};
            if (mayLower(prepared.sweep)) {
                lowerByAll(table);
                table.clear();
                *record = lower(prepared);
            }
            ++record;
        }
        lowerByAll(table);
    }

    TileCut result() {
        // A copy in which nothing changed is dropped.
        if (m_result.copy && m_result.copy->heights == m_zmap.tile(m_index).heights)
            m_result.copy.reset();
        return std::move(m_result);
    }

private:
    [[nodiscard]] const Tile& tile() const { return m_tile != nullptr ? *m_tile : m_zmap.tile(m_index); }

    /// A tile that is entirely below the cutter, or entirely on the floor, cannot change.
    [[nodiscard]] bool mayLower(const Sweep& sweep) const {
        return static_cast<double>(tile().maximum) > sweep.lowest() && tile().maximum > m_floor;
    }

    [[nodiscard]] bool mayContinue() {
        m_result.complete = !m_stop.stop_requested();
        return m_result.complete;
    }

    /// The passes over this tile; valid until the next call.
    [[nodiscard]] std::span<const TilePass> seen(const PreparedSweep& prepared) {
        const Vec2 first(m_place.x(m_rect.i0), m_place.y(m_rect.j0));
        const Vec2 middle = first + kMiddle * Vec2(m_grid.hx, m_grid.hy) - prepared.sweep.origin();
        m_passes.clear();
        prepared.passes.addOverTile(middle.x, middle.y, m_spacing, m_passes);
        return m_passes;
    }

    /// Adds the passes of a sweep to the table, or lowers the tile at once if it has none.
    void collect(const PreparedSweep& prepared, PassTable& table) {
        if (!mayLower(prepared.sweep))
            return;
        if (prepared.passes.empty())
            (void)lower(prepared);
        for (const TilePass& pass : seen(prepared))
            table.add(pass);
    }

    void lowerByAll(PassTable& table) {
        if (table.size() == 0 || (m_tile == nullptr && !proveout::mayLower(table.passes(), tile(), m_floor)))
            return;
        acquire();
        table.arrange();
        m_result.complete = proveout::lowerByAll(table, *m_work, m_stop) && m_result.complete;
        m_tile->updateMaximum();
    }

    void lowerByPasses(const PreparedSweep& prepared) {
        const std::span<const TilePass> passes = seen(prepared);
        if (passes.empty() || (m_tile == nullptr && !proveout::mayLower(passes, tile(), m_floor)))
            return;
        acquire();
        if (m_marks != nullptr)
            m_work->mark(m_marks->data(), m_mark);
        const TileLoss loss = lowerByMotion(passes, *m_work, m_weights ? &*m_weights : nullptr, m_stop);
        (void)mayContinue();
        if (loss.points == 0)
            return;
        m_tile->updateMaximum();
        m_sums.record.removedMm3 = loss.sum;
        m_sums.record.maxDepth = static_cast<double>(loss.depth);
        m_sums.record.points = loss.points;
        m_sums.record.engagedFrom = loss.engagedFrom;
        m_sums.record.engagedTo = loss.engagedTo;
        m_sums.record.changed = {m_rect.i0 + std::countr_zero(loss.columns),
                                 m_rect.j0 + std::countr_zero(loss.rows),
                                 m_rect.i0 + static_cast<int>(std::bit_width(loss.columns)),
                                 m_rect.j0 + static_cast<int>(std::bit_width(loss.rows))};
    }

    void lowerRows(const Sweep& sweep) {
        const Box3& reach = sweep.reach();
        const double rows = m_rect.height();
        const double lo =
            std::clamp(std::ceil((reach.lo.y - m_grid.y0) / m_grid.hy - 1e-6) - m_rect.j0, 0.0, rows);
        const double hi =
            std::clamp(std::floor((reach.hi.y - m_grid.y0) / m_grid.hy + 1e-6) - m_rect.j0 + 1, 0.0, rows);
        for (int row = static_cast<int>(lo); row < static_cast<int>(hi) && mayContinue(); ++row)
            lower(sweep, row);
    }

    void lower(const Sweep& sweep, int row) {
        const RowPoints points{m_place.x(m_rect.i0), m_grid.hx, m_place.y(m_rect.j0 + row), m_rect.width()};
        const Columns columns = sweep.row(
            points, &tile().heights[static_cast<std::size_t>(row * Tile::kSize)], m_envelope.data());
        if (columns.empty())
            return;
        const int begin = columns.begin / kLanes * kLanes;
        const int end = (columns.end + kLanes - 1) / kLanes * kLanes;
        lower(sweep, row, columns, begin, end);
        std::fill(m_envelope.begin() + begin, m_envelope.begin() + end, kInfinity);
    }

    /// Lowers the whole lanes [begin, end) that contain the evaluated columns.
    void lower(const Sweep& sweep, int row, const Columns& columns, int begin, int end) {
        const auto at = static_cast<std::size_t>(row * Tile::kSize + begin);
        if (!anyLower(&m_envelope[static_cast<std::size_t>(begin)], &tile().heights[at], end - begin,
                      m_floor))
            return;
        acquire();
        const bool edge = isEdge(row);
        lowerRow(&m_envelope[static_cast<std::size_t>(begin)], &m_tile->heights[at],
                 &m_removed[static_cast<std::size_t>(begin)], end - begin, m_floor,
                 edge ? m_sums.edge : m_sums.inner);
        note(row, columns, edge);
        noteEngagement(sweep, row, columns);
        if (m_marks != nullptr)
            mark(row, columns);
    }

    /// Whether the row is on the border of the map, where points weigh half.
    [[nodiscard]] bool isEdge(int row) const {
        return m_rect.j0 + row == 0 || m_rect.j0 + row == m_grid.ny - 1;
    }

    void acquire() {
        if (m_tile != nullptr)
            return;
        m_tile = m_zmap.ownedTile(m_index);
        if (m_tile == nullptr) {
            m_result.copy = std::make_shared<Tile>(m_zmap.tile(m_index));
            m_tile = m_result.copy.get();
        }
        m_work.emplace(*m_tile, m_floor);
    }

    /// Records where points of a row were lowered, and what the first and last column of the map lost.
    void note(int row, const Columns& columns, bool edge) {
        int first = columns.begin;
        while (!(m_removed[static_cast<std::size_t>(first)] > 0))
            ++first;
        int last = columns.end;
        while (!(m_removed[static_cast<std::size_t>(last - 1)] > 0))
            --last;
        const int j = m_rect.j0 + row;
        m_sums.record.changed = hull(m_sums.record.changed, {m_rect.i0 + first, j, m_rect.i0 + last, j + 1});
        const double weight = edge ? 0.25 : 0.5;
        if (first == 0 && m_rect.i0 == 0)
            m_sums.columnHalves += weight * static_cast<double>(m_removed[0]);
        if (m_rect.i0 + last == m_grid.nx)
            m_sums.columnHalves +=
                weight * static_cast<double>(m_removed[static_cast<std::size_t>(last - 1)]);
    }

    void noteEngagement(const Sweep& sweep, int row, const Columns& columns) {
        CutRecord& record = m_sums.record;
        for (int k = columns.begin; k < columns.end; ++k) {
            if (!(m_removed[static_cast<std::size_t>(k)] > 0))
                continue;
            const auto beside =
                static_cast<float>(sweep.beside({m_grid.x(m_rect.i0 + k), m_grid.y(m_rect.j0 + row)}));
            record.engagedFrom = std::min(record.engagedFrom, beside);
            record.engagedTo = std::max(record.engagedTo, beside);
        }
    }

    void mark(int row, const Columns& columns) {
        for (int k = columns.begin; k < columns.end; ++k) {
            if (m_removed[static_cast<std::size_t>(k)] > 0)
                (*m_marks)[static_cast<std::size_t>(row * Tile::kSize + k)] = m_mark;
        }
    }

    void finishRows() {
        CutRecord& record = m_sums.record;
        for (const LaneSums* sums : {&m_sums.inner, &m_sums.edge}) {
            for (std::size_t lane = 0; lane < kLanes; ++lane) {
                record.points += sums->points[lane];
                record.maxDepth = std::max(record.maxDepth, static_cast<double>(sums->depth[lane]));
            }
        }
        record.removedMm3 = total(m_sums.inner) + total(m_sums.edge) / 2 - m_sums.columnHalves;
        if (record.points == 0)
            return;
        m_tile->loweredPoints += static_cast<std::uint32_t>(record.points);
        if (m_tile->loweredPoints < kRefreshAfter)
            return;
        m_tile->refreshMaximum();
        m_work->forget();
    }

    ZMap& m_zmap;
    std::size_t m_index;
    const std::stop_token& m_stop;
    Provenance::Marks* m_marks;
    const Grid& m_grid;
    const GridPart m_place;
    TileSpacing m_spacing;
    IndexRect m_rect;
    float m_floor;
    Tile* m_tile = nullptr;
    std::optional<TileUnderWork> m_work; ///< if the tile is owned, so that it can be lowered in place
    std::vector<TilePass> m_passes;
    std::uint32_t m_mark = 1; ///< of the current sweep
    std::optional<PointWeights> m_weights;
    Row m_envelope; ///< +infinity between two rows
    Row m_removed;
    TileCut m_result;

    /// The sums of one sweep.
    struct Sums {
        CutRecord record;
        LaneSums inner;
        LaneSums edge;
        double columnHalves = 0;
    } m_sums;
};

} // namespace

TileCut lowerTile(ZMap& zmap, std::size_t index, std::span<const PreparedSweep> sweeps,
                  std::span<const std::uint32_t> order, std::span<CutRecord> records,
                  const std::stop_token& stop, Provenance::Marks* marks) {
    TileWork work(zmap, index, GridPart(zmap.grid()), stop, marks);
    for (std::size_t k = 0; k < order.size(); ++k)
        records[k] = work.lower(sweeps[order[k]]);
    return work.result();
}

TileCut lowerTileInTurn(ZMap& zmap, std::size_t index, std::span<const PreparedSweep> sweeps,
                        std::span<const std::uint32_t> order, std::span<CutRecord> records, PassTable& table,
                        const std::stop_token& stop) {
    TileWork work(zmap, index, GridPart(zmap.grid()), stop, nullptr);
    work.lowerInTurn(sweeps, order, records, table);
    return work.result();
}

TileCut lowerTileByAll(ZMap& zmap, std::size_t index, std::span<const PreparedSweep> sweeps,
                       std::span<const std::uint32_t> order, PassTable& table, const GridPart& place,
                       const std::stop_token& stop) {
    TileWork work(zmap, index, place, stop, nullptr);
    work.lowerByAll(sweeps, order, table);
    return work.result();
}

} // namespace proveout
