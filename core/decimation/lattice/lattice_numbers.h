// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace proveout {

/// Assigns 0, 1, 2, … to the grid points that a mesh uses, in the order of their first use. Memory grows with
/// the points that are used: a decimated mesh uses one of a thousand. Owned by one thread.
class LatticeNumbers {
public:
    static constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();

    /// `points`: number of points of the whole grid.
    explicit LatticeNumbers(std::size_t points) : m_blocks(points / kBlock + 1) {}

    /// The number of a grid point; assigns the next one if it has none.
    std::uint32_t number(std::uint32_t lattice) {
        std::unique_ptr<Block>& block = m_blocks[lattice / kBlock];
        if (!block) {
            block = std::make_unique<Block>();
            block->fill(kUnused);
        }
        std::uint32_t& number = (*block)[lattice % kBlock];
        if (number == kUnused) {
            number = static_cast<std::uint32_t>(m_used.size());
            m_used.push_back(lattice);
        }
        return number;
    }
    /// kUnused if it has none.
    [[nodiscard]] std::uint32_t find(std::uint32_t lattice) const {
        const std::unique_ptr<Block>& block = m_blocks[lattice / kBlock];
        return block ? (*block)[lattice % kBlock] : kUnused;
    }
    /// The grid points by number.
    [[nodiscard]] const std::vector<std::uint32_t>& used() const { return m_used; }
    /// used() as the last call: moves the list out, so that its memory is freed with the result.
    [[nodiscard]] std::vector<std::uint32_t> releaseUsed() && { return std::move(m_used); }

private:
    static constexpr std::size_t kBlock = 64;
    using Block = std::array<std::uint32_t, kBlock>;

    std::vector<std::unique_ptr<Block>> m_blocks; ///< of successive grid points; null: none is used
    std::vector<std::uint32_t> m_used;
};

} // namespace proveout
