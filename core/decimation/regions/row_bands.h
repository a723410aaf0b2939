// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace proveout {

/// The rows of a map in bands, and for each band the triangles that reach into it: so the bands can be
/// measured by several threads, each with the memory of one band. Rows are counted from the first one of the
/// map.
class RowBands {
public:
    static constexpr std::size_t kRows = 16; ///< of a band

    struct Rows {
        std::size_t first = 0;
        std::size_t last = 0; ///< inclusive; none if it is before `first`
        [[nodiscard]] bool empty() const { return last < first; }
    };

    /// `rowsOf(t)`: the rows that triangle `t` of `triangles` reaches, within [0, rows).
    template<class RowsOf>
    RowBands(std::size_t rows, std::size_t triangles, const RowsOf& rowsOf)
        : m_rows(rows), m_begins(count() + 1) {
        const auto eachBand = [&](std::size_t triangle, const auto& visit) {
            const Rows reached = rowsOf(triangle);
            if (!reached.empty())
                for (std::size_t band = reached.first / kRows; band <= reached.last / kRows; ++band)
                    visit(band);
        };
        for (std::size_t t = 0; t < triangles; ++t)
            eachBand(t, [&](std::size_t band) { ++m_begins[band + 1]; });
        for (std::size_t band = 0; band < count(); ++band)
            m_begins[band + 1] += m_begins[band];
        m_triangles.resize(m_begins.back());
        std::vector<std::size_t> next(m_begins.begin(), m_begins.end() - 1);
        for (std::size_t t = 0; t < triangles; ++t)
            eachBand(t, [&](std::size_t band) { m_triangles[next[band]++] = static_cast<std::uint32_t>(t); });
    }

    [[nodiscard]] std::size_t count() const { return (m_rows + kRows - 1) / kRows; }
    [[nodiscard]] Rows rows(std::size_t band) const {
        return {band * kRows, std::min((band + 1) * kRows, m_rows) - 1};
    }
    /// Ascending.
    [[nodiscard]] std::span<const std::uint32_t> trianglesOf(std::size_t band) const {
        return {m_triangles.begin() + static_cast<std::ptrdiff_t>(m_begins[band]),
                m_triangles.begin() + static_cast<std::ptrdiff_t>(m_begins[band + 1])};
    }

private:
    std::size_t m_rows;
    std::vector<std::size_t> m_begins; ///< by band: its first entry in m_triangles; finally the end
    std::vector<std::uint32_t> m_triangles;
};

} // namespace proveout
