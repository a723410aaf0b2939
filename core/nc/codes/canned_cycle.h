// SPDX-License-Identifier: GPL-3.0-or-later
// The canned cycles of all dialects, as what they do in a hole, step by step.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/base/geometry.h"
#include "core/nc/codes/codes.h"
#include "core/nc/text/dialect.h"
#include "core/nc/text/messages.h"

namespace proveout {

/// One thing that a canned cycle does in a hole.
enum class CycleStep : std::uint8_t {
    none,
    rapidToR,
    feedToBottom,
    peckAndRetract,   ///< G83: out to R after each peck
    peckAndBreakChip, ///< G73: a little back after each peck
    tapToBottom,      ///< in one go, or by pecks with the spindle reversed in between
    tapToR,           ///< as fast as the order says
    dwell,
    turnAsNeeded, ///< the way that a tap goes in
    reverseSpindle,
    stopSpindle,
    restoreSpindle, ///< as before the hole
    stopProgram,    ///< for the operator, who retracts by hand
    feedToR,
    feedToClearance,
    rapidToClearance,
    shiftAside,
    shiftBack,
    backBore,         ///< G87 of LinuxCNC as a whole
    mixedToBottom,    ///< LinuxCNC's tap: outside of G17 with its axes mixed up
    mixedToClearance, ///< likewise
    startedAsLeft     ///< LinuxCNC takes the tool to be out of the hole, wherever it is
};

enum class SpindleNeed : std::uint8_t { any, turning, clockwise, counterClockwise };

/// What a canned cycle needs and does.
struct CannedCycle {
    static constexpr std::size_t kMostSteps = 12;

    int tenths;  ///< 810 is G81
    bool dwells; ///< P is its own
    bool pecks;  ///< Q is the depth of its pecks
    SpindleNeed spindle;
    std::array<CycleStep, kMostSteps> steps;
    bool shifts = false;                ///< Q is how far it moves aside
    bool upward = false;                ///< it bores from R up, and always returns to the initial level
    const FindingRow* caveat = nullptr; ///< what cannot be shown of it
};

[[nodiscard]] bool isCycle(const CodeRow* row);
/// The cycle of a row of which `isCycle` is true.
[[nodiscard]] const CannedCycle& cycleOf(DialectId dialect, const CodeRow& row);

/// How deep the pecks of a hole are, in mm. Each is `less` shorter than the one before, but not shorter than
/// `least`; 0: the hole is drilled in one go.
struct Pecks {
    double first = 0;
    double less = 0;
    double least = 0;
    double clearing = 0; ///< so deep by pecks, then out to R (0: never)

    /// How many it takes to get so deep: no fewer than are made. Infinite where they never do.
    [[nodiscard]] double count(double depth) const;
};

/// What one canned cycle leaves to the next of the same series, in mm.
struct CycleState {
    double initialLevel = 0; ///< where the series began, in program coordinates
    double bottom = 0;       ///< LinuxCNC: as the words said; else in program coordinates
    double retract = 0;      ///< R, likewise
    double peck = 0;         ///< Q
    double dwell = 0;        ///< seconds
    bool initialKnown = false;
    bool bottomGiven = false;
    bool retractGiven = false;
    bool rigid = false;          ///< M29 came before the series
    bool doubtsReported = false; ///< what cannot be shown of the cycle in force
    Pecks shrinking;             ///< Haas: I J K
    Vec3 aside{0};               ///< I J K of a cycle that shifts
    bool asideGiven = false;
    double outRatio = 1; ///< Haas: J of a tapping cycle

    /// LinuxCNC keeps its lengths as numbers: they are others in another unit.
    void reinterpret(double ratio) {
        for (double* length : {&initialLevel, &bottom, &retract, &peck})
            *length *= ratio;
        aside *= ratio;
    }
};

} // namespace proveout
