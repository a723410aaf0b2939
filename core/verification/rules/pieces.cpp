// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verification/rules/pieces.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>

#include "core/base/parallel.h"

namespace proveout {

namespace {

/// Neighbouring columns of a row above the floor.
struct Run {
    int begin;
    int end;
    std::size_t piece;
};

/// Pieces while they are found: some turn out to be one.
class Pieces {
public:
    std::size_t add(const Piece& piece) {
        m_pieces.push_back(piece);
        m_same.push_back(m_same.size());
        return m_same.size() - 1;
    }
    void join(std::size_t one, std::size_t other) {
        one = root(one);
        other = root(other);
        if (one == other)
            return;
        const auto [kept, gone] = std::minmax(one, other);
        m_same[gone] = kept;
        m_pieces[kept].volumeMm3 += m_pieces[gone].volumeMm3;
        m_pieces[gone].volumeMm3 = 0;
    }
    void addVolume(std::size_t piece, double volume) { m_pieces[root(piece)].volumeMm3 += volume; }
    [[nodiscard]] const std::vector<Piece>& all() const { return m_pieces; }
    [[nodiscard]] std::size_t root(std::size_t piece) {
        while (m_same[piece] != piece) {
            m_same[piece] = m_same[m_same[piece]];
            piece = m_same[piece];
        }
        return piece;
    }

private:
    std::vector<Piece> m_pieces;
    std::vector<std::size_t> m_same; ///< the index of an earlier piece that it is a part of, or its own
};

/// Those of a row, ascending, that touch the columns [begin, end) of the next row. `from` is moved to the
/// first of them, or of those behind them.
std::span<const Run> touchingOf(const std::vector<Run>& row, std::vector<Run>::const_iterator& from,
                                int begin, int end) {
    while (from != row.cend() && from->end <= begin)
        ++from;
    auto last = from;
    while (last != row.cend() && last->begin < end)
        ++last;
    return {from, last};
}

/// The pieces of some rows, as if there were no others.
struct Band {
    Pieces pieces;
    std::vector<Run> first; ///< of the first row
    std::vector<Run> last;
};

class BandSearch {
public:
    BandSearch(const ZMapSnapshot& stock, int rows)
        : m_stock(stock), m_rows(rows), m_heights(static_cast<std::size_t>(stock.grid().nx)) {}

    [[nodiscard]] Band band(std::size_t index) {
        Band band;
        const int first = static_cast<int>(index) * m_rows;
        const int last = std::min(first + m_rows, m_stock.grid().ny);
        for (int j = first; j < last; ++j) {
            band.last = runs(band.pieces, band.last, j);
            if (j == first)
                band.first = band.last;
        }
        return band;
    }

private:
    /// The runs of a row, in the pieces of those in the row before it that they touch.
    std::vector<Run> runs(Pieces& pieces, const std::vector<Run>& before, int j) {
        const Grid& grid = m_stock.grid();
        m_stock.read({0, j, grid.nx, j + 1}, m_heights);
        std::vector<Run> out;
        auto above = before.cbegin();
        for (int i = 0; i < grid.nx;) {
            if (!isAbove(i)) {
                ++i;
                continue;
            }
            int end = i + 1;
            while (end < grid.nx && isAbove(end))
                ++end;
            const Piece own{sum(i, end) * grid.hx * grid.hy,
                            Vec3(grid.x(i), grid.y(j), m_stock.stock().topZ() + double{heightAt(i)})};
            const auto touching = touchingOf(before, above, i, end);
            const std::size_t piece = touching.empty() ? pieces.add(own) : touching.front().piece;
            for (const Run& run : touching)
                pieces.join(piece, run.piece);
            if (!touching.empty())
                pieces.addVolume(piece, own.volumeMm3);
            out.push_back({i, end, piece});
            i = end;
        }
        return out;
    }

    [[nodiscard]] float heightAt(int i) const { return m_heights[static_cast<std::size_t>(i)]; }
    [[nodiscard]] bool isAbove(int i) const { return heightAt(i) > m_stock.floor(); }
    /// Of the heights above the floor, in lanes, which the compiler may turn into vectors.
    [[nodiscard]] double sum(int begin, int end) const {
        constexpr int kLanes = 8;
        std::array<double, kLanes> lanes{};
        int i = begin;
        for (; i + kLanes <= end; i += kLanes)
            for (int lane = 0; lane < kLanes; ++lane)
                lanes[static_cast<std::size_t>(lane)] += double{heightAt(i + lane) - m_stock.floor()};
        double all = 0;
        for (; i < end; ++i)
            all += double{heightAt(i) - m_stock.floor()};
        for (const double lane : lanes)
            all += lane;
        return all;
    }

    const ZMapSnapshot& m_stock;
    int m_rows;
    std::vector<float> m_heights;
};

} // namespace

std::vector<Piece> piecesOf(const ZMapSnapshot& stock) {
    constexpr int kRows = 64; // of a band
    std::vector<Band> bands(static_cast<std::size_t>((stock.grid().ny + kRows - 1) / kRows));
    inParallelRanges(bands.size(), 1, [&](std::size_t first, std::size_t last) {
        BandSearch search(stock, kRows);
        for (std::size_t index = first; index < last; ++index)
            bands[index] = search.band(index);
    });
    Pieces pieces;
    std::vector<Run> before;
    for (Band& band : bands) {
        const std::size_t offset = pieces.all().size();
        for (const Piece& piece : band.pieces.all())
            (void)pieces.add(piece);
        for (std::size_t k = 0; k < band.pieces.all().size(); ++k)
            pieces.join(offset + band.pieces.root(k), offset + k);
        auto above = before.cbegin();
        for (const Run& run : band.first)
            for (const Run& touching : touchingOf(before, above, run.begin, run.end))
                pieces.join(touching.piece, offset + run.piece);
        before = std::move(band.last);
        for (Run& run : before)
            run.piece += offset;
    }
    std::vector<Piece> found;
    for (std::size_t k = 0; k < pieces.all().size(); ++k)
        if (pieces.root(k) == k)
            found.push_back(pieces.all()[k]);
    return found;
}

} // namespace proveout
