// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "core/decimation/regions/parameters.h"

namespace proveout {

/// The parameters with which the row of each block was computed, used to mark where they changed: after a
/// seek back and a change, old and new rows are next to each other.
class ParameterTrace {
public:
    /// Of `rows` blocks, those from `first` up to `executed` were recomputed with these parameters.
    void update(const DecimationParameters& parameters, std::size_t first, std::size_t executed,
                std::size_t rows);
    /// The last block before each change of parameters, ascending; block numbers start at 1.
    [[nodiscard]] std::vector<std::size_t> changes() const;

private:
    std::uint32_t numberOf(const DecimationParameters& parameters);
    void resize(std::size_t rows, std::uint32_t added);
    void assign(std::size_t first, std::size_t end, std::uint32_t used);

    std::vector<DecimationParameters> m_seen; ///< without duplicates, so that a change that was undone is not
                                              ///< marked
    /// Index into m_seen, by the first block of each run of blocks that use the same; few at any number of
    /// blocks.
    std::map<std::size_t, std::uint32_t> m_runs;
    std::size_t m_rows = 0;
};

} // namespace proveout
