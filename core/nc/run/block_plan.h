// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "core/nc/codes/codes.h"
#include "core/nc/state/execution.h"

namespace proveout {

/// What a block orders, sorted by the step at which it takes effect.
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

/// Finds out what a block orders and tells what is wrong with it. Codes that are not supported leave their
/// mark in the state at once: axes forgotten, a motion mode that moves nothing. False: the block
/// contradicts itself and must not run. The plan points into the block.
[[nodiscard]] bool makePlan(Execution& execution, BlockPlan& plan);

} // namespace proveout
