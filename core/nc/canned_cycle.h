// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "core/base/geometry.h"
#include "core/nc/codes.h"

namespace proveout {

/// One thing that a canned cycle does in a hole. Source: LinuxCNC's documentation of G73 to G89, in the order
/// in which its stand-alone interpreter does it.
enum class CycleStep : std::uint8_t {
    none,
    feedToBottom,
    peckAndRetract,   ///< G83: out to R after each peck
    peckAndBreakChip, ///< G73: a little back after each peck
    dwell,
    reverseSpindle,
    stopSpindle,
    restoreSpindle, ///< as before the hole
    stopProgram,    ///< for the operator, who retracts by hand
    feedToR,
    feedToClearance,
    rapidToClearance,
    backBore ///< G87 as a whole
};

enum class SpindleNeed : std::uint8_t { any, turning, clockwise, counterClockwise };

/// What a canned cycle needs and does.
struct CannedCycle {
    static constexpr std::size_t kMostSteps = 5;

    int tenths;  ///< 810 is G81
    bool dwells; ///< P is required
    bool pecks;  ///< Q is required
    SpindleNeed spindle;
    std::array<CycleStep, kMostSteps> steps;
};

/// Null where the code is no canned cycle.
[[nodiscard]] const CannedCycle* findCycle(const CodeRow* row);

/// What one canned cycle leaves to the next of the same series, in mm.
struct CycleState {
    double initialLevel = 0; ///< where the series began, in program coordinates
    double bottom = 0;       ///< as the words said: with G91 they count from elsewhere
    double retract = 0;      ///< R, as the word said
    double peck = 0;
    double dwell = 0; ///< seconds
};

} // namespace proveout
