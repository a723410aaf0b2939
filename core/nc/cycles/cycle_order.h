// SPDX-License-Identifier: GPL-3.0-or-later
// The values that the words of a canned cycle give by the rules of the dialect: read here, executed by
// cycle_run.h.
#pragma once

#include <optional>

#include "core/base/geometry.h"
#include "core/nc/codes/canned_cycle.h"
#include "core/nc/state/execution.h"

namespace proveout {

/// The holes of one block. Levels are program coordinates along the normal of the plane, lengths mm.
struct CycleOrder {
    double retract = 0;
    double bottom = 0;
    bool lifts = false;   ///< moves to R before the first hole
    double travel = 0;    ///< level of the move to the first hole, if the position of the tool is known
    double clearance = 0; ///< level to which the tool retracts after a hole
    double dwell = 0;     ///< seconds
    Pecks pecks;
    double remainder = 0; ///< a shorter last peck is omitted
    Vec3 aside{0};        ///< relative to the hole, for a cycle with a shift
    double boreTop = 0;   ///< the level up to which LinuxCNC's G87 bores
    double outRatio = 1;  ///< ratio of the feed of a tap out of the hole to its feed into the hole
    long long repeats = 1;
};

/// Nothing if the block does not drill, which is reported unless it is allowed. Changes the state of the
/// series.
[[nodiscard]] std::optional<CycleOrder> readCycle(Execution& execution, const Word& word,
                                                  const CannedCycle& cycle);
/// By LinuxCNC's rules, and by Fanuc's with those of Haas.
[[nodiscard]] std::optional<CycleOrder> readRs274Cycle(Execution& execution, const Word& word,
                                                       const CannedCycle& cycle);
[[nodiscard]] std::optional<CycleOrder> readFanucCycle(Execution& execution, const Word& word,
                                                       const CannedCycle& cycle);
/// The values of Fanuc's cycle in force, without words of its own: one hole.
[[nodiscard]] CycleOrder fanucOrderInForce(const Execution& execution, const CannedCycle& cycle);

/// Whether the spindle turns as the cycle requires; reports it if not.
[[nodiscard]] bool spindleTurns(Execution& execution, const Word& word, SpindleNeed need);
/// Reports a code of a reference position within a canned cycle if the control refuses that.
void reportReferenceInCycle(Execution& execution, const Word& word);
/// Whether the position of the tool along the normal of the plane is known.
[[nodiscard]] bool depthKnown(const Execution& execution);

} // namespace proveout
