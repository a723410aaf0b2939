// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace proveout {

/// A set of blocks of a program, 0-based; a bit for each block. Value type.
class BlockSet {
public:
    [[nodiscard]] bool contains(std::size_t block) const { return block < m_bits.size() && m_bits[block]; }
    [[nodiscard]] bool empty() const { return m_bits.empty(); }
    /// After the last block; 0 if it is empty.
    [[nodiscard]] std::size_t end() const { return m_bits.size(); }

    /// The smallest; end() if it is empty.
    [[nodiscard]] std::size_t first() const {
        return static_cast<std::size_t>(std::find(m_bits.begin(), m_bits.end(), true) - m_bits.begin());
    }

    void add(std::size_t block) {
        if (block >= m_bits.size())
            m_bits.resize(block + 1);
        m_bits[block] = true;
    }

private:
    std::vector<bool> m_bits; ///< the last one is set
};

} // namespace proveout
