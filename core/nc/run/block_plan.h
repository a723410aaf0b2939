// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "core/nc/codes/codes.h"
#include "core/nc/state/execution.h"

namespace proveout {

/// The actions of a block, sorted by the step at which they take effect.
class BlockPlan {
public:
    void add(Step step, CodeHandler handler, const Word& word,
             WithCompensation withCompensation = WithCompensation::allowed) {
        m_orders[static_cast<std::size_t>(step)] = {handler, &word, withCompensation};
        m_present |= std::uint64_t{1} << static_cast<unsigned>(step);
    }

    void run(Execution& execution) const;

private:
    struct Order {
        CodeHandler handler;
        const Word* word;
        WithCompensation withCompensation;
    };

    std::uint64_t m_present = 0;
    std::array<Order, static_cast<std::size_t>(Step::count)> m_orders;
};

/// Determines the actions of a block and reports its errors. Codes that are not supported change the state at
/// once: positions of axes become unknown, or a motion mode does not move anything. False: the block
/// contradicts itself and must not run. The plan points into the block.
[[nodiscard]] bool makePlan(Execution& execution, BlockPlan& plan);

} // namespace proveout
