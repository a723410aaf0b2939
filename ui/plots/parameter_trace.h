// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/decimation/regions/parameters.h"

namespace proveout {

/// With which parameters the rows of the blocks were made, to mark where they changed: after a seek back and
/// a change, old and new rows stand side by side.
class ParameterTrace {
public:
    /// Of `rows` blocks, those from `first` up to `executed` were made anew with these parameters.
    void update(const DecimationParameters& parameters, std::size_t first, std::size_t executed,
                std::size_t rows);
    /// The last blocks before other parameters, ascending; as block numbers, which begin at 1.
    [[nodiscard]] std::vector<std::size_t> changes() const;

private:
    std::uint32_t numberOf(const DecimationParameters& parameters);

    std::vector<DecimationParameters> m_seen; ///< each once, so that a change and its undoing meet unmarked
    std::vector<std::uint32_t> m_used;        ///< a row of m_seen a block
};

} // namespace proveout
