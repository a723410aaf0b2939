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

/// The meaning of the F word.
enum class FeedMode : std::uint8_t {
    perMinute,     ///< G94
    inverseTime,   ///< G93: 1/minutes of the one motion
    perRevolution, ///< G95
};

/// Everything that one block passes on to the next. A value: saving and restoring it is a copy. Lengths are
/// in mm, for any unit of the program.
struct MachineState {
    const CodeRow* motion = nullptr; ///< the motion code in force; null after G80 and at the start
    Plane plane = Plane::xy;
    bool inch = false;
    bool incremental = false;       ///< G91
    bool arcCentreAbsolute = false; ///< G90.1
    bool arcCentreChosen = false;   ///< G90.1 or G91.1 was executed
    bool retractToR = true;         ///< G99, the initial state of LinuxCNC
    bool ended = false;             ///< M2 or M30 was executed
    bool mist = false;
    bool flood = false;

    FeedMode feedMode = FeedMode::perMinute;
    double feed = 0;           ///< mm/min, 1/min or mm, depending on the mode; 0: none given
    double feedNumber = 0;     ///< as programmed by F, in the unit that was in force
    double spindleRpm = 0;     ///< as programmed by S
    bool surfaceSpeed = false; ///< G96: S is the surface speed, and the spindle follows X
    double mostRpm = 0;        ///< by D of G96; 0: none given
    int spindleDirection = 0;  ///< 1 clockwise, -1 counter-clockwise, 0 stopped
    int selectedTool = -1;     ///< by T; -1: none yet
    int tool = 0;              ///< in the spindle; 0: none

    CycleState cycle;
    Vec3 intermediate{0};               ///< of the last move to a reference position, in program coordinates
    std::uint8_t intermediateKnown = 0; ///< AxisBits of it
    bool rigidTapping = false;          ///< M29 waits for its tapping cycle

    bool machineZeroKnown = false; ///< whether machine coordinates can be computed from program coordinates
    WorkFrame frame;
    bool shifted = false; ///< G92, G52 or G92.3 is in force, for any amount
    Vec3 toolOffset{0};   ///< in force, by G43 and similar codes
    int lengthSign = 0;   ///< 1 for G43, -1 for G44, 0 without
    int workOffset = 1;   ///< 1 for G54 to 9 for G59.3
    /// What the program has written into #5220 since then: LinuxCNC returns it instead, and it has no other
    /// effect.
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
    bool straightDue = false; ///< since G40, a straight motion is needed before the next arc
    OrderedCorner corner;     ///< of Fanuc's dialect

    /// Of the tip of the cutter, in machine coordinates; the programmed position, even if cutter compensation
    /// displaces it.
    Vec3 position{0};
    std::uint8_t known = 0;     ///< AxisBits of `position`
    bool zAtReference = false;  ///< unknown, but at the machine's reference position
    std::uint8_t everKnown = 0; ///< AxisBits that were known at the end of any motion
    /// From the position that the control assumes for the tip to the real one. LinuxCNC assumes that the tip
    /// is out of the hole after G88, and after G74 and G84 outside of G17.
    Vec3 strayed{0};

    // What has been reported already, so that it is reported once.
    std::uint8_t unknownReported = 0; ///< AxisBits
    bool missingFeedReported = false;
    bool referenceReported = false;
    bool arcCentreReported = false;
    bool dwellUnitReported = false;

    ProbeState probed;
    bool inputAssumed = false; ///< M66 put an unknown value into #5399, and nothing has read it yet

    /// Speed of the spindle while it turns; 0 if G96 does not determine it.
    [[nodiscard]] double rpm() const { return surfaceSpeed ? mostRpm : spindleRpm; }
    [[nodiscard]] double toMm(double value) const { return inch ? value * kMmPerInch : value; }
    [[nodiscard]] double fromMm(double value) const { return inch ? value / kMmPerInch : value; }
};

} // namespace proveout
