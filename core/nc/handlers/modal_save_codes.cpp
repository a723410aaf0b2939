// SPDX-License-Identifier: GPL-3.0-or-later
// M70 to M73: the modal state is saved, discarded and restored.
#include "core/nc/codes/handlers.h"
#include "core/nc/state/execution.h"
#include "core/nc/state/modal_saves.h"

namespace proveout {

void saveModes(Execution& execution, const Word& /*word*/) {
    execution.saves.save(execution.callLevel, execution.state, false);
}

void saveModesUntilReturn(Execution& execution, const Word& /*word*/) {
    execution.saves.save(execution.callLevel, execution.state, true);
}

void discardModes(Execution& execution, const Word& /*word*/) {
    execution.saves.discard(execution.callLevel);
}

void restoreModes(Execution& execution, const Word& word) {
    const MachineState* saved = execution.saves.at(execution.callLevel);
    if (saved == nullptr) {
        execution.reporter.report(nc_message::kNothingSaved, word);
        return;
    }
    LetterSet others = execution.block.letters();
    others.remove(LetterSet("N"));
    if (execution.block.codes().size() > 1 || !others.empty())
        execution.reporter.report(nc_message::kRestoreNotAlone, word);
    restore(execution, *saved, word);
}

void restore(Execution& execution, const MachineState& saved, const Word& word) {
    for (const Block& block : blocksToRestore(execution.state, saved, execution.dialect, word)) {
        Execution inner = execution.at(block);
        executeBlock(inner);
    }
}

} // namespace proveout
