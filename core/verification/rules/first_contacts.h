// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/simulation/run/block_set.h"
#include "core/verification/rules/checked_run.h"

namespace proveout {

/// The first block in which a tool cuts: where the operator keeps a finger on feed hold.
struct FirstContact {
    int tool = 0;
    std::size_t block = 0; ///< 0-based
    Vec3 start{0};         ///< of the first motion of the block whose path is known
};

/// Of every tool that cuts, in the order of the program. Any thread.
[[nodiscard]] std::vector<FirstContact> firstContacts(const CheckedRun& run);
/// Adds the blocks whose records are missing for them.
void needForFirstContacts(const CheckedRun& run, BlockSet& out);

} // namespace proveout
