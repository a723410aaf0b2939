// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace proveout {

/// The heights of single points of a map, to be found by a shader: a hash table with open addressing, laid
/// out in rows for a texture (resources/shaders/partial_heights.glsl has the same search). It accesses no
/// memory but its own.
class PointTable {
public:
    static constexpr std::size_t kRow = 1024; ///< entries
    static constexpr std::uint32_t kNoPoint = 0xFFFF'FFFF;

    struct Entry {
        std::uint32_t point = kNoPoint; ///< its lattice index
        float height = 0;
    };

    /// Empty, in the largest table of at most `bytes`.
    void reset(std::size_t bytes);
    /// Removes all points.
    void clear();
    /// False if no more points can be added.
    [[nodiscard]] bool add(std::uint32_t point, float height);
    /// Sets the height of a point that may be in the table.
    void set(std::uint32_t point, float height);

    [[nodiscard]] bool empty() const { return m_used == 0; }
    [[nodiscard]] std::size_t rows() const { return m_entries.size() / kRow; }
    [[nodiscard]] std::span<const Entry> row(std::size_t row) const {
        return std::span(m_entries).subspan(row * kRow, kRow);
    }
    /// The product of a point and kHashFactor, shifted right by this, is the first place to search.
    [[nodiscard]] int shift() const { return m_shift; }
    /// The rows that have changed since the last call.
    [[nodiscard]] std::vector<std::size_t> takeChangedRows();

    static constexpr std::uint32_t kHashFactor = 2654435769U; ///< 2³² by the golden ratio: Fibonacci hashing

private:
    /// Where a point is, or would be.
    [[nodiscard]] std::size_t placeOf(std::uint32_t point) const;
    void put(std::size_t place, std::uint32_t point, float height);

    std::vector<Entry> m_entries; ///< a power of two of them
    std::vector<bool> m_changed;  ///< per row
    std::size_t m_used = 0;
    int m_shift = 0;
};

} // namespace proveout
