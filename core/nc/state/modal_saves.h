// SPDX-License-Identifier: GPL-3.0-or-later
// The modal states that M70 and M73 save, and that M72 restores.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/nc/state/machine_state.h"
#include "core/nc/text/block.h"
#include "core/nc/text/dialect.h"

namespace proveout {

/// The saved states, at most one for each level of calls; level 0 is the main program. Source: LinuxCNC, M70
/// to M73. A value.
class ModalSaves {
public:
    /// `untilReturn`: the state is restored automatically when the run of the subprogram ends (M73).
    void save(std::size_t level, const MachineState& state, bool untilReturn);
    void discard(std::size_t level);
    /// Null if nothing is saved at this level.
    [[nodiscard]] const MachineState* at(std::size_t level) const;
    /// A subprogram at this level has ended: its saved state is removed. Returns the state to be restored.
    [[nodiscard]] std::optional<MachineState> endRun(std::size_t level);

private:
    struct Save {
        MachineState state;
        bool untilReturn = false;
    };
    std::vector<std::optional<Save>> m_saves; ///< by level
};

/// The blocks that lead from the modes of one state to those of another, in order, all words at the place of
/// `word`: as LinuxCNC restores them, by codes for the differences. Neither motion nor tool is restored.
[[nodiscard]] std::vector<Block> blocksToRestore(const MachineState& from, const MachineState& to,
                                                 const Dialect& dialect, const Word& word);

} // namespace proveout
