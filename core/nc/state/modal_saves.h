// SPDX-License-Identifier: GPL-3.0-or-later
// What M70 and M73 keep of the modal state, and what M72 restores of it.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/nc/state/machine_state.h"
#include "core/nc/text/block.h"
#include "core/nc/text/dialect.h"

namespace proveout {

/// The states that are kept, at most one for each level of calls; level 0 is the main program. Source:
/// LinuxCNC, M70 to M73. A value.
class ModalSaves {
public:
    /// `untilReturn`: the state comes back by itself when the run of the subprogram ends (M73).
    void save(std::size_t level, const MachineState& state, bool untilReturn);
    void discard(std::size_t level);
    /// Null where nothing is kept at this level.
    [[nodiscard]] const MachineState* at(std::size_t level) const;
    /// A subprogram at this level has ended: nothing is kept there any more. The state that has to come back.
    [[nodiscard]] std::optional<MachineState> endRun(std::size_t level);

private:
    struct Save {
        MachineState state;
        bool untilReturn = false;
    };
    std::vector<std::optional<Save>> m_saves; ///< by level
};

/// The blocks that lead from the modes of one state to those of another, in their order, all words at the
/// place of `word`: as LinuxCNC restores, by codes for what differs. Neither motion nor tool is restored.
[[nodiscard]] std::vector<Block> blocksToRestore(const MachineState& from, const MachineState& to,
                                                 const Dialect& dialect, const Word& word);

} // namespace proveout
