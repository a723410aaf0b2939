// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace proveout {

/// Some of the regions of a grid. Listing them takes the time of those that are in it: the others are passed
/// 64 at a time.
class RegionSet {
public:
    RegionSet() = default;
    /// All of `count` regions.
    explicit RegionSet(std::size_t count)
        : m_words((count + kBits - 1) / kBits, std::numeric_limits<std::uint64_t>::max()), m_size(count) {
        if (count % kBits != 0)
            m_words.back() >>= kBits - count % kBits;
    }

    [[nodiscard]] std::size_t size() const { return m_size; }
    [[nodiscard]] bool contains(std::size_t region) const {
        return (m_words[region / kBits] >> region % kBits & 1U) != 0;
    }
    void insert(std::size_t region) {
        m_size += contains(region) ? 0 : 1;
        m_words[region / kBits] |= std::uint64_t{1} << region % kBits;
    }
    void erase(std::size_t region) {
        m_size -= contains(region) ? 1 : 0;
        m_words[region / kBits] &= ~(std::uint64_t{1} << region % kBits);
    }
    /// Ascending.
    [[nodiscard]] std::vector<std::size_t> list() const {
        std::vector<std::size_t> regions;
        regions.reserve(m_size);
        for (std::size_t word = 0; word < m_words.size() && regions.size() < m_size; ++word)
            for (std::uint64_t bits = m_words[word]; bits != 0; bits &= bits - 1)
                regions.push_back(word * kBits + static_cast<std::size_t>(std::countr_zero(bits)));
        return regions;
    }

private:
    static constexpr std::size_t kBits = 64;
    std::vector<std::uint64_t> m_words;
    std::size_t m_size = 0;
};

} // namespace proveout
