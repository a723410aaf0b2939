// SPDX-License-Identifier: GPL-3.0-or-later
// Probing: G38.2 to G38.5, and G31 of Fanuc. Only a real machine finds where the probe touches the part; if
// there is a simulated stock, it is probed instead.
#include <cmath>
#include <fmt/format.h>
#include <string>

#include "core/base/figures_argument.h"
#include "core/nc/codes/handlers.h"
#include "core/nc/motions/motion_sink.h"
#include "core/nc/motions/motion_target.h"
#include "core/nc/program/probe_target.h"
#include "core/nc/state/execution.h"
#include "core/nc/state/machine_values.h"
#include "core/nc/state/probing.h"

namespace proveout {

namespace {

using Seek = ProbeTarget::Seek;
using Kind = ProbeTarget::Answer::Kind;

constexpr int kContactAxes = 9; ///< the number that LinuxCNC knows

constexpr int kTowards = 382; ///< G38.2; the codes that do not report an error are one tenth higher
constexpr int kAway = 384;

constexpr double kRounding = 1e-9; ///< left in a position by adding and subtracting offsets, mm

bool mayProbe(Execution& execution, const Word& word) {
    if (!execution.block.letters().any(LetterSet("XYZ@^"))) {
        execution.reporter.report(nc_message::kWordMissing, word, {nameOf(word), "X / Y / Z"});
        return false;
    }
    if (execution.state.feedMode == FeedMode::perRevolution) {
        execution.reporter.report(nc_message::kProbePerRevolution, word);
        return false;
    }
    return true;
}

ProbeTarget::Answer ask(Execution& execution, const Motion& motion, Seek seek) {
    execution.state.probed.asked = true;
    if (execution.target == nullptr || !motion.known())
        return {};
    Motion seen = motion;
    seen.start = tipAt(execution, motion.start);
    return execution.target->probe(execution.program, seen, seek, execution.limits.context);
}

std::vector<Argument> coordinates(const Vec3& place) {
    const auto shown = [&](int axis) { return figures("{:.3f}", place[axis] + 0.0); };
    return {shown(0), shown(1), shown(2)};
}

/// Executes the motion according to the answer, and stores where it stopped.
void stopWhere(Execution& execution, const Word& word, Motion motion, const ProbeTarget::Answer& answer,
               Seek seek) {
    MachineState& state = execution.state;
    if (answer.kind == Kind::found)
        motion.end = answer.place;
    motion.probing = true;
    const Vec3 place = state.frame.toProgram(motion.end);
    if (answer.kind == Kind::found)
        execution.reporter.report(seek == Seek::contact ? nc_message::kProbeContact
                                                        : nc_message::kProbeRelease,
                                  word, coordinates(place));
    appendMotion(execution, motion);
    state.probed.place = place;
    state.probed.simulated = answer.kind != Kind::unknown;
    for (int axis = 0; axis < 3; ++axis)
        if (state.probed.simulated && motion.start[axis] != motion.end[axis])
            state.probed.axes |= axisBit(axis);
}

void reportAssumed(Execution& execution, const Word& word, const FindingRow& message) {
    if (execution.state.probed.assumedReported)
        return;
    execution.state.probed.assumedReported = true;
    execution.reporter.report(message, word);
}

/// Stores the result in program coordinates, in the unit of the program.
void storeResult(Execution& execution, bool success) {
    for (int axis = 0; axis < kContactAxes; ++axis)
        execution.parameters.setNumbered(kProbeContact + axis,
                                         axis < 3 ? execution.state.fromMm(execution.state.probed.place[axis])
                                                  : 0.0);
    execution.parameters.setNumbered(kProbeSuccess, success ? 1 : 0);
}

/// Stores Mach's result, for the existing axes.
void storeMachResult(Execution& execution) {
    for (int axis = 0; axis < kMachAxes; ++axis)
        execution.parameters.setNumbered(
            kMachProbed + axis, axis < 3 ? execution.state.fromMm(execution.state.probed.place[axis]) : 0.0);
}

/// Reports what a machine answers with an error, after which it does not continue.
void reportFailure(Execution& execution, const Word& word, Kind kind, int tenths) {
    const bool towards = tenths < kAway;
    const std::string code = fmt::format("G{:g}", tenths / 10.0);
    if (kind == Kind::already)
        execution.reporter.report(towards ? nc_message::kProbeTouches : nc_message::kProbeFree, word, {code});
    else if (kind == Kind::missed && (tenths == kTowards || tenths == kAway))
        execution.reporter.report(towards ? nc_message::kProbeMissed : nc_message::kProbeHeld, word, {code});
}

} // namespace

void probe(Execution& execution, const Word& word) {
    if (!mayProbe(execution, word)) {
        arrive(execution.state, motionToTarget(execution, MotionKind::feed));
        return;
    }
    const Motion motion = motionToTarget(execution, MotionKind::feed);
    reportMissingFeed(execution, word);
    reportUnknownStart(execution, motion, word);
    if (motion.known() && glm::distance(motion.start, motion.end) < kRounding) {
        execution.reporter.report(nc_message::kProbeTooClose, word);
        return;
    }
    const int tenths = execution.state.motion->tenths;
    const Seek seek = tenths < kAway ? Seek::contact : Seek::release;
    const ProbeTarget::Answer answer = ask(execution, motion, seek);
    if (answer.kind == Kind::unknown)
        reportAssumed(execution, word, nc_message::kProbeAssumed);
    reportFailure(execution, word, answer.kind, tenths);
    if (answer.kind == Kind::already)
        return;
    stopWhere(execution, word, motion, answer, seek);
    storeResult(execution, answer.kind == Kind::found);
}

/// Without a signal the motion simply ends; if the signal is on already, nothing moves.
void skipMotion(Execution& execution, const Word& word) {
    const Motion motion = motionToTarget(execution, MotionKind::feed);
    reportMissingFeed(execution, word);
    reportUnknownStart(execution, motion, word);
    ProbeTarget::Answer answer = ask(execution, motion, Seek::contact);
    if (answer.kind == Kind::unknown)
        reportAssumed(execution, word, nc_message::kSkipAssumed);
    if (answer.kind == Kind::already)
        answer = {Kind::found, motion.start};
    stopWhere(execution, word, motion, answer, Seek::contact);
    if (execution.dialect.macros != MacroLanguage::macroB)
        storeMachResult(execution);
}

void reportProbeUse(MachineState& state, Reporter& reporter) {
    if (!state.probed.simulated || state.probed.useReported)
        return;
    state.probed.useReported = true;
    reporter.report(nc_message::kProbeUsed, 1, 0);
}

namespace {

/// Whether the block has G92 or G10 L20, which set coordinates relative to the position of the machine.
bool countsFromHere(const Block& block) {
    constexpr double kPreset = 92;
    constexpr double kData = 10;
    constexpr double kFromHere = 20;
    for (const Word& word : block.codes())
        if (word.letter == 'G' && (word.value == kPreset ||
                                   (word.value == kData && block.has('L') && block.value('L') == kFromHere)))
            return true;
    return false;
}

/// AxisBits of the axes that the block names.
std::uint8_t namedAxes(const Block& block) {
    std::uint8_t named = 0;
    for (int axis = 0; axis < 3; ++axis)
        if (block.has(static_cast<char>('X' + axis)))
            named |= axisBit(axis);
    return named;
}

} // namespace

void lookForProbeUse(Execution& execution, std::uint8_t axes, std::size_t firstMotion) {
    MachineState& state = execution.state;
    if (axes == 0)
        return;
    const std::uint8_t named = namedAxes(execution.block);
    const bool moved = execution.program.motionCount() > firstMotion;
    if (moved && !execution.program.motion(firstMotion).probing) {
        const bool placed = !state.incremental || execution.machineCoordinates;
        state.probed.axes &= static_cast<std::uint8_t>(state.known & (placed ? ~named : 0xff));
        if (state.probed.axes != 0)
            reportProbeUse(state, execution.reporter);
    } else if (!moved && (axes & named) != 0 && countsFromHere(execution.block)) {
        reportProbeUse(state, execution.reporter);
    }
}

} // namespace proveout
