// SPDX-License-Identifier: GPL-3.0-or-later
// What the words of a canned cycle order, by the rules of the dialect: read here, drilled by cycle_run.h.
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
    bool lifts = false;   ///< to R before the first hole
    double travel = 0;    ///< level on the way to the first hole, if it is known where the tool stands
    double clearance = 0; ///< level at which a hole is left
    double dwell = 0;     ///< seconds
    Pecks pecks;
    double remainder = 0; ///< a shorter last peck is none
    Vec3 aside{0};        ///< from the hole, of a cycle that shifts
    double boreTop = 0;   ///< up to which LinuxCNC's G87 bores
    double outRatio = 1;  ///< of the feed with which a tap comes out to the one of going in
    long long repeats = 1;
};

/// Nothing where the block drills nothing, which is told unless it is in order. Changes the state of the
/// series.
[[nodiscard]] std::optional<CycleOrder> readCycle(Execution& execution, const Word& word,
                                                  const CannedCycle& cycle);
/// By LinuxCNC's rules, and by Fanuc's with those of Haas.
[[nodiscard]] std::optional<CycleOrder> readRs274Cycle(Execution& execution, const Word& word,
                                                       const CannedCycle& cycle);
[[nodiscard]] std::optional<CycleOrder> readFanucCycle(Execution& execution, const Word& word,
                                                       const CannedCycle& cycle);
/// The order of Fanuc's cycle in force, without words of its own: one hole.
[[nodiscard]] CycleOrder fanucOrderInForce(const Execution& execution, const CannedCycle& cycle);

/// Whether the spindle turns as the cycle needs it; tells it where not.
[[nodiscard]] bool spindleTurns(Execution& execution, const Word& word, SpindleNeed need);
/// Tells where a code of a reference position stands within a canned cycle and the control refuses that.
void reportReferenceInCycle(Execution& execution, const Word& word);
/// Whether it is known where the tool stands along the normal of the plane.
[[nodiscard]] bool depthKnown(const Execution& execution);

} // namespace proveout
