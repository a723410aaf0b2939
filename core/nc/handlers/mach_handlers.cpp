// SPDX-License-Identifier: GPL-3.0-or-later
// Where Mach differs from LinuxCNC and Fanuc. Source: Using Mach3Mill, chapter 10.
#include <cmath>
#include <numbers>
#include <string>

#include "core/nc/codes/handlers.h"
#include "core/nc/handlers/offset_setting.h"
#include "core/nc/motions/arc_words.h"
#include "core/nc/motions/compensated_path.h"
#include "core/nc/motions/motion_sink.h"
#include "core/nc/motions/motion_target.h"
#include "core/nc/state/execution.h"

namespace proveout {

namespace {

bool inXyPlane(Execution& execution, const Word& word) {
    if (execution.state.plane == Plane::xy)
        return true;
    execution.reporter.report(nc_message::kPlaneXyOnly, word, {nameOf(word)});
    return false;
}

/// Moves along X by I, around the position where the tool was, and back to it.
void millCircle(Execution& execution, const Word& word, double turn) {
    if (!inXyPlane(execution, word))
        return;
    if (!execution.block.has('I')) {
        execution.reporter.report(nc_message::kWordMissing, word, {nameOf(word), "I"});
        return;
    }
    const WorkFrame& frame = execution.state.frame;
    const Vec3 middle = frame.toProgram(execution.state.position);
    const Vec3 side = frame.toMachine(middle + Vec3(execution.length('I'), 0, 0));
    Motion out = motionFromHere(execution, MotionKind::feed);
    reportMissingFeed(execution, word);
    reportUnknownStart(execution, out, word);
    out.end = side;
    const Vec3 centre = out.start;
    appendMotion(execution, out);
    Motion circle = motionFromHere(execution, MotionKind::arc);
    circle.centre = centre;
    circle.sweep = turn * 2 * std::numbers::pi * (frame.transformation.flips(Plane::xy) ? -1 : 1);
    if (planeKnown(circle) && fitForSize(execution, word, circle))
        appendMotion(execution, circle);
    Motion back = motionFromHere(execution, MotionKind::feed);
    back.end = centre;
    appendMotion(execution, back);
}

/// False, with a report, if the offset is 0.
bool numberGiven(Execution& execution, const Word& word) {
    if (execution.block.has('H') && execution.block.value('H') != 0)
        return true;
    execution.reporter.report(nc_message::kLengthNumberMissing, word, {nameOf(word)});
    setToolOffset(execution, Vec3(0));
    return false;
}

} // namespace

void millCircleClockwise(Execution& execution, const Word& word) {
    millCircle(execution, word, -1);
}

void millCircleCounterClockwise(Execution& execution, const Word& word) {
    millCircle(execution, word, 1);
}

void beginPolarHere(Execution& execution, const Word& word) {
    if (!inXyPlane(execution, word))
        return;
    const MachineState& state = execution.state;
    const Vec3 here = state.frame.toProgram(state.position);
    if (here.x != 0 || here.y != 0 || (state.known & kAxisX) == 0 || (state.known & kAxisY) == 0)
        execution.reporter.report(nc_message::kPolarPole, word);
    execution.state.polar = {true, here, 0, 0};
}

void referenceAxes(Execution& execution, const Word& word) {
    execution.reporter.report(nc_message::kAxesReferenced, word, {nameOf(word)});
    const bool all = !execution.block.letters().any(kAxisWords);
    Motion motion = motionFromHere(execution, MotionKind::rapid);
    for (int axis = 0; axis < 3; ++axis) {
        if (all || execution.block.has(static_cast<char>('X' + axis)))
            motion.endKnown &= static_cast<std::uint8_t>(~axisBit(axis));
    }
    appendMotion(execution, motion);
}

void useNumberedLength(Execution& execution, const Word& word) {
    if (numberGiven(execution, word))
        useToolLength(execution, word);
}

void subtractNumberedLength(Execution& execution, const Word& word) {
    if (numberGiven(execution, word))
        subtractToolLength(execution, word);
}

void scaleByAxis(Execution& execution, const Word& word) {
    if (!execution.block.letters().any(kAxisWords)) {
        execution.reporter.report(nc_message::kWordMissing, word, {nameOf(word), "X"});
        return;
    }
    Transformation& now = execution.state.frame.transformation;
    Vec3 factors = now.factors;
    for (int axis = 0; axis < 3; ++axis) {
        const char letter = static_cast<char>('X' + axis);
        if (!execution.block.has(letter))
            continue;
        factors[axis] = execution.block.value(letter);
        if (factors[axis] == 0) {
            execution.reporter.report(nc_message::kScaleFactor, execution.block.word(letter),
                                      {std::string(1, letter)});
            return;
        }
    }
    // Words are scaled before anything else, so that the program zero does not move.
    now.factors = factors;
    now.scaleAt = Vec3(0);
    now.scaled = true;
}

void turnByPoint(Execution& execution, const Word& word) {
    if (!inXyPlane(execution, word))
        return;
    const Block& block = execution.block;
    // Mach3 gives the centre by A and B, Mach4 by X and Y.
    const bool mach4 = block.letters().any(LetterSet("XY"));
    for (const char letter : {mach4 ? 'X' : 'A', mach4 ? 'Y' : 'B', 'R'}) {
        if (!block.has(letter)) {
            execution.reporter.report(nc_message::kWordMissing, word, {nameOf(word), std::string(1, letter)});
            return;
        }
    }
    Transformation& now = execution.state.frame.transformation;
    const Vec3 centre(execution.length(mach4 ? 'X' : 'A'), execution.length(mach4 ? 'Y' : 'B'), 0);
    now.degrees = block.value('R') + (block.has('I') && now.turned ? now.degrees : 0);
    now.turned = true;
    now.plane = Plane::xy;
    now.turnAt = now.stretch(centre);
    execution.state.turning = {now.mixedAxes(), false};
}

void selectNumberedSystem(Execution& execution, const Word& word) {
    constexpr double kG59 = 59;
    constexpr int kStandard = 6;
    const bool g59 = word.value == kG59;
    if (!execution.block.has('P')) {
        if (g59)
            selectWorkOffset(execution, word);
        else
            execution.reporter.report(nc_message::kWordMissing, word, {nameOf(word), "P"});
        return;
    }
    const int first = g59 ? 0 : kStandard;
    const int most = kStandard + execution.dialect.additionalSystems - first;
    if (const auto number = wholeNumber(execution, execution.block.word('P'), 1, most))
        selectSystem(execution, first + *number);
}

void beginAgain(Execution& execution, const Word& word) {
    if (execution.callLevel > 0) {
        execution.reporter.report(nc_message::kCodeForeign, word, {nameOf(word)});
        return;
    }
    finishCompensated(execution, word);
    execution.reporter.report(nc_message::kProgramRepeats, word);
    execution.program.append(ProgramEnd{}, execution.line);
    execution.state.ended = true;
}

} // namespace proveout
