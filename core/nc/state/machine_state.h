// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "core/base/geometry.h"
#include "core/nc/codes/canned_cycle.h"
#include "core/nc/codes/codes.h"
#include "core/nc/geometry/work_frame.h"
#include "core/nc/program/motion.h"
#include "core/nc/state/compensation_state.h"
#include "core/nc/state/ordered_corner.h"
#include "core/nc/state/polar_mode.h"
#include "core/nc/state/probing.h"
#include "core/nc/state/turning.h"

namespace proveout {

constexpr double kMmPerInch = 25.4;

/// What the F word counts.
enum class FeedMode : std::uint8_t {
    perMinute,     ///< G94
    inverseTime,   ///< G93: 1/minutes of the one motion
    perRevolution, ///< G95
};

/// Everything that one block leaves behind for the next. A value: saving and restoring it is a copy.
/// Lengths are in mm whatever the unit of the program.
struct MachineState {
    const CodeRow* motion = nullptr; ///< the motion code in force; null after G80 and at the start
    Plane plane = Plane::xy;
    bool inch = false;
    bool incremental = false;       ///< G91
    bool arcCentreAbsolute = false; ///< G90.1
    bool arcCentreChosen = false;   ///< G90.1 or G91.1 was executed
    bool retractToR = true;         ///< G99, with which LinuxCNC begins
    bool ended = false;             ///< M2 or M30 was executed
    bool mist = false;
    bool flood = false;

    FeedMode feedMode = FeedMode::perMinute;
    double feed = 0;           ///< mm/min, 1/min or mm by mode; 0: none given
    double feedNumber = 0;     ///< as F said, in the unit that was in force
    double spindleRpm = 0;     ///< as S said
    bool surfaceSpeed = false; ///< G96: S counts along the cut, and the spindle follows X
    double mostRpm = 0;        ///< by D of G96; 0: none given
    int spindleDirection = 0;  ///< 1 clockwise, -1 counter-clockwise, 0 stopped
    int selectedTool = -1;     ///< by T; -1: none yet
    int tool = 0;              ///< in the spindle; 0: none

    CycleState cycle;
    Vec3 intermediate{0};               ///< of the last way to a reference position, in program coordinates
    std::uint8_t intermediateKnown = 0; ///< AxisBits of it
    bool rigidTapping = false;          ///< M29 waits for its tapping cycle

    bool machineZeroKnown = false; ///< whether machine coordinates can be told from program coordinates
    WorkFrame frame;
    bool shifted = false; ///< G92, G52 or G92.3 counts, whatever its amount
    Vec3 toolOffset{0};   ///< in force, by G43 and its like
    int lengthSign = 0;   ///< 1 for G43, -1 for G44, 0 without
    int workOffset = 1;   ///< 1 for G54 to 9 for G59.3
    /// What the program wrote into #5220 since then: LinuxCNC tells it instead, and nothing else comes of it.
    std::optional<double> writtenOffset;

    // Of Fanuc's dialect.
    Vec3 presetShift{0};     ///< G92; part of frame.shift
    Vec3 localShift{0};      ///< G52; part of frame.shift
    int lengthRegister = 0;  ///< H
    int radiusRegister = 0;  ///< D
    double pathControl = 64; ///< G61 to G64
    double lastM = 0;
    double lastB = 0;
    bool modalMacro = false;  ///< G66 is in force
    double blockNumber = 0;   ///< N
    double programNumber = 0; ///< O
    PolarMode polar;
    Turning turning;
    bool dataInput = false; ///< from G10 L50 to G11

    CutterCompensation compensation;
    bool straightDue = false; ///< since G40, before the next arc
    OrderedCorner corner;     ///< of Fanuc's dialect

    /// Of the tip of the cutter, in machine coordinates; where the text says that it is, even if cutter
    /// compensation displaces it.
    Vec3 position{0};
    std::uint8_t known = 0;     ///< AxisBits of `position`
    bool zAtReference = false;  ///< not known, but at the machine's reference position
    std::uint8_t everKnown = 0; ///< AxisBits that were known at the end of any motion
    /// From where the control takes the tip to be to where it is. LinuxCNC takes it to be out of the hole
    /// behind G88, and behind G74 and G84 outside of G17.
    Vec3 strayed{0};

    // What was told already, so that it is told once.
    std::uint8_t unknownReported = 0; ///< AxisBits
    bool missingFeedReported = false;
    bool referenceReported = false;
    bool arcCentreReported = false;
    bool dwellUnitReported = false;

    ProbeState probed;
    bool inputAssumed = false; ///< M66 put into #5399 what nobody knows, and nothing has read it yet

    /// Of the spindle where it turns; 0 where G96 leaves it open.
    [[nodiscard]] double rpm() const { return surfaceSpeed ? mostRpm : spindleRpm; }
    [[nodiscard]] double toMm(double value) const { return inch ? value * kMmPerInch : value; }
    [[nodiscard]] double fromMm(double value) const { return inch ? value / kMmPerInch : value; }
};

} // namespace proveout
