// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verification/rules/pieces.h"

#include <algorithm>
#include <cstddef>

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
    std::size_t add(const Vec3& place) {
        m_pieces.push_back({0, place});
        m_same.push_back(m_same.size());
        return m_same.size() - 1;
    }
    void addVolume(std::size_t piece, double volume) { m_pieces[piece].volumeMm3 += volume; }
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
    std::size_t root(std::size_t piece) {
        while (m_same[piece] != piece) {
            m_same[piece] = m_same[m_same[piece]];
            piece = m_same[piece];
        }
        return piece;
    }
    [[nodiscard]] std::vector<Piece> found() const {
        std::vector<Piece> pieces;
        for (std::size_t k = 0; k < m_pieces.size(); ++k)
            if (m_same[k] == k)
                pieces.push_back(m_pieces[k]);
        return pieces;
    }

private:
    std::vector<Piece> m_pieces;
    std::vector<std::size_t> m_same; ///< the index of an earlier piece that it is a part of, or its own
};

} // namespace

std::vector<Piece> piecesOf(const ZMapSnapshot& stock) {
    const Grid& grid = stock.grid();
    const float floor = stock.floor();
    const double cell = grid.hx * grid.hy;
    Pieces pieces;
    std::vector<float> heights(static_cast<std::size_t>(grid.nx));
    std::vector<Run> before;
    std::vector<Run> now;
    for (int j = 0; j < grid.ny; ++j) {
        stock.read({0, j, grid.nx, j + 1}, heights);
        now.clear();
        auto above = before.cbegin();
        for (int i = 0; i < grid.nx;) {
            if (!(heights[static_cast<std::size_t>(i)] > floor)) {
                ++i;
                continue;
            }
            Run run{i, i, 0};
            double sum = 0;
            for (; run.end < grid.nx && heights[static_cast<std::size_t>(run.end)] > floor; ++run.end)
                sum += static_cast<double>(heights[static_cast<std::size_t>(run.end)] - floor);
            while (above != before.cend() && above->end <= run.begin)
                ++above;
            if (above != before.cend() && above->begin < run.end) {
                run.piece = pieces.root(above->piece);
                for (auto next = above + 1; next != before.cend() && next->begin < run.end; ++next)
                    pieces.join(run.piece, next->piece);
            } else {
                const double z =
                    stock.stock().topZ() + static_cast<double>(heights[static_cast<std::size_t>(i)]);
                run.piece = pieces.add({grid.x(i), grid.y(j), z});
            }
            pieces.addVolume(pieces.root(run.piece), sum * cell);
            now.push_back(run);
            i = run.end;
        }
        before.swap(now);
    }
    return pieces.found();
}

} // namespace proveout
