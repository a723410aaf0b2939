// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core/simulation/run/block_cutter.h"
#include "core/verification/rules/checked_run.h"

namespace proveout {

/// The stock before a block. The program is cut once more for it, for its heights alone; blocks are asked for
/// in ascending order. One thread.
class StockOfMoment {
public:
    /// `run` has kept its uncut stock.
    explicit StockOfMoment(const CheckedRun& run) : m_run(run), m_map(*run.begin) {}

    const ZMap& before(std::size_t block) {
        (void)cutBlocks(m_map, m_run.program, m_block, block, m_run.setup, m_run.tools, {}, m_cutting);
        m_block = block;
        return m_map;
    }

private:
    const CheckedRun& m_run;
    ZMap m_map;
    std::size_t m_block = 0; ///< the blocks before it have been cut
    PortionCutting m_cutting;
};

} // namespace proveout
