// SPDX-License-Identifier: GPL-3.0-or-later
// The canned cycles of all dialects, as sequences of steps in a hole.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/base/geometry.h"
#include "core/nc/codes/codes.h"
#include "core/nc/text/dialect.h"
#include "core/nc/text/messages.h"

namespace proveout {

/// One step of a canned cycle in a hole.
enum class CycleStep : std::uint8_t {
    none,
    rapidToR,
    feedToBottom,
    peckAndRetract,   ///< G83: out to R after each peck
    peckAndBreakChip, ///< G73: a short retract after each peck
    tapToBottom,      ///< in one pass, or by pecks with the spindle reversed in between
    tapToR,           ///< at the feed that CycleOrder gives
    dwell,
    turnAsNeeded, ///< in the direction in which the tap goes in
    reverseSpindle,
    stopSpindle,
    restoreSpindle, ///< restored to the state before the hole
    stopProgram,    ///< for the operator, who retracts manually
    feedToR,
    feedToClearance,
    rapidToClearance,
    shiftAside,
    shiftBack,
    backBore,         ///< the whole G87 of LinuxCNC
    mixedToBottom,    ///< LinuxCNC's tap: outside of G17, its axes are mixed up
    mixedToClearance, ///< the same, to the clearance level
    startedAsLeft     ///< LinuxCNC assumes that the tool is out of the hole, wherever it is
};

enum class SpindleNeed : std::uint8_t { any, turning, clockwise, counterClockwise };

/// What a canned cycle needs and does.
struct CannedCycle {
    static constexpr std::size_t kMostSteps = 12;

    int tenths;  ///< 810 is G81
    bool dwells; ///< P is its dwell time
    bool pecks;  ///< Q is the depth of its pecks
    SpindleNeed spindle;
    std::array<CycleStep, kMostSteps> steps;
    bool shifts = false;                ///< Q is how far it moves aside
    bool upward = false;                ///< it bores from R up, and always returns to the initial level
    const FindingRow* caveat = nullptr; ///< the part of it that cannot be simulated
};

[[nodiscard]] bool isCycle(const CodeRow* row);
/// The cycle of a row for which `isCycle` is true.
[[nodiscard]] const CannedCycle& cycleOf(DialectId dialect, const CodeRow& row);

/// The depth of the pecks of a hole, in mm. Each is `less` shorter than the one before, but not shorter than
/// `least`; 0: the hole is drilled in one pass.
struct Pecks {
    double first = 0;
    double less = 0;
    double least = 0;
    double clearing = 0; ///< depth by pecks after which the tool retracts to R (0: never)

    /// At least the number of pecks to this depth; infinite if they never reach it.
    [[nodiscard]] double count(double depth) const;
};

/// The values that one canned cycle passes on to the next of the same series, in mm.
struct CycleState {
    double initialLevel = 0; ///< where the series began, in program coordinates
    double bottom = 0;       ///< LinuxCNC: as programmed; otherwise in program coordinates
    double retract = 0;      ///< R, in the same form
    double peck = 0;         ///< Q
    double dwell = 0;        ///< seconds
    bool initialKnown = false;
    bool bottomGiven = false;
    bool retractGiven = false;
    bool rigid = false;          ///< M29 came before the series
    bool doubtsReported = false; ///< whether the doubts about the cycle in force have been reported
    Pecks shrinking;             ///< Haas: I J K
    Vec3 aside{0};               ///< I J K of a cycle with a shift
    bool asideGiven = false;
    double outRatio = 1; ///< Haas: J of a tapping cycle

    /// LinuxCNC keeps lengths as plain numbers, so they change their meaning with the unit.
    void reinterpret(double ratio) {
        for (double* length : {&initialLevel, &bottom, &retract, &peck})
            *length *= ratio;
        aside *= ratio;
    }
};

} // namespace proveout
