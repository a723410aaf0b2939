// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/motions/motion_target.h"

#include <cmath>
#include <numbers>
#include <string>

#include "core/nc/motions/motion_sink.h"
#include "core/nc/motions/polar_words.h"
#include "core/nc/motions/turning_notice.h"

namespace proveout {

namespace {

/// Sets the feed, as far as it does not depend on the length of the path.
void setFeed(Motion& motion, const MachineState& state) {
    motion.perRevolution = state.feedMode == FeedMode::perRevolution;
    if (motion.perRevolution)
        motion.feedMmPerMin = state.feed * std::abs(motion.spindleRpm);
    else if (state.feedMode == FeedMode::perMinute)
        motion.feedMmPerMin = state.feed;
}

} // namespace

Motion motionFromHere(const Execution& execution, MotionKind kind) {
    const MachineState& state = execution.state;
    Motion motion;
    motion.kind = kind;
    motion.plane = state.plane;
    motion.line = execution.line;
    motion.tool = state.tool;
    motion.spindleRpm = state.spindleDirection * state.rpm();
    motion.orderedRpm = state.rpm();
    if (kind != MotionKind::rapid)
        setFeed(motion, state);
    motion.start = motion.end = state.position;
    motion.startKnown = motion.endKnown = state.known;
    motion.startAtReference = motion.endAtReference = state.zAtReference;
    return motion;
}

void setMachineTarget(Execution& execution, Motion& motion, int axis, double value) {
    MachineState& state = execution.state;
    if (state.machineZeroKnown) {
        motion.end[axis] = value;
        motion.endKnown |= axisBit(axis);
        return;
    }
    motion.endKnown &= static_cast<std::uint8_t>(~axisBit(axis));
    constexpr int kZ = 2;
    if (axis == kZ)
        motion.endAtReference = value == 0;
    if (!state.referenceReported) {
        state.referenceReported = true;
        execution.reporter.report(nc_message::kReferenceUnknown, 1, 0, {std::string(1, letterOfAxis(axis))});
    }
}

std::optional<Vec2> polarTarget(Execution& execution, const Vec3& program, std::uint8_t known) {
    const Block& block = execution.block;
    if (!block.letters().any(LetterSet("@^")))
        return {};
    const bool incremental = execution.state.incremental;
    constexpr std::uint8_t kBoth = kAxisX | kAxisY;
    if ((incremental || !block.has('@') || !block.has('^')) && (known & kBoth) != kBoth) {
        const Word& word = block.word(block.has('@') ? '@' : '^');
        execution.reporter.report(nc_message::kIncrementalUnknown, word, {std::string(1, word.letter)});
        return {};
    }
    if ((incremental || !block.has('^')) && program.x == 0 && program.y == 0) {
        const Word& word = block.word(block.has('@') ? '@' : '^');
        execution.reporter.report(nc_message::kPolarOrigin, word, {std::string(1, word.letter)});
        return {};
    }
    double radius = std::hypot(program.x, program.y);
    double angle = std::atan2(program.y, program.x);
    if (block.has('@'))
        radius = execution.length('@') + (incremental ? radius : 0);
    if (block.has('^'))
        angle = block.value('^') * std::numbers::pi / 180 + (incremental ? angle : 0);
    return Vec2(radius * std::cos(angle), radius * std::sin(angle));
}

namespace {

/// The program coordinate that the word of an axis gives; false if it is relative to an unknown position.
bool axisTarget(Execution& execution, int axis, std::uint8_t known, Vec3& program) {
    MachineState& state = execution.state;
    const char letter = letterOfAxis(axis);
    const double value = execution.length(letter);
    if (!state.incremental) {
        program[axis] = value;
        return true;
    }
    if ((known & axisBit(axis)) != 0) {
        program[axis] += value;
        return true;
    }
    if ((state.unknownReported & axisBit(axis)) == 0) {
        state.unknownReported |= axisBit(axis);
        execution.reporter.report(nc_message::kIncrementalUnknown, execution.block.word(letter),
                                  {std::string(1, letter)});
    }
    return false;
}

/// Under a rotation, the machine's position along an axis depends on more than its own word.
std::uint8_t bitsThatTurn(const WorkFrame& frame, std::uint8_t bits) {
    const std::uint8_t mixed = frame.mixedAxes();
    return (bits & mixed) != mixed ? static_cast<std::uint8_t>(bits & ~mixed) : bits;
}

/// Reads the axis words of the block into program coordinates; returns AxisBits of the named axes.
std::uint8_t readAxisWords(Execution& execution, Motion& motion, std::uint8_t known, Vec3& program) {
    const MachineState& state = execution.state;
    std::uint8_t named = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const char letter = letterOfAxis(axis);
        if (!execution.block.has(letter))
            continue;
        if (execution.machineCoordinates)
            setMachineTarget(execution, motion, axis, execution.length(letter) - state.toolOffset[axis]);
        else if (state.polar.on && axis != axes(state.plane).normal)
            continue;
        else if (axisTarget(execution, axis, known, program))
            named |= axisBit(axis);
    }
    if (state.polar.on)
        return static_cast<std::uint8_t>(named | readPolarWords(execution, known, program));
    if (const auto polar = polarTarget(execution, program, static_cast<std::uint8_t>(known | named))) {
        program.x = polar->x;
        program.y = polar->y;
        named |= kAxisX | kAxisY;
    }
    return named;
}

} // namespace

Motion motionToTarget(Execution& execution, MotionKind kind) {
    const MachineState& state = execution.state;
    Motion motion = motionFromHere(execution, kind);
    const WorkFrame& frame = state.frame;
    Vec3 program = frame.toProgram(state.position);
    std::uint8_t known = bitsThatTurn(frame, state.known);
    const std::uint8_t named = readAxisWords(execution, motion, known, program);
    known |= named;
    if (named == 0)
        return motion;
    if (state.turning.axes != 0)
        reportTurning(execution, named);
    const Vec3 machine = frame.toMachine(program);
    const std::uint8_t mixed = frame.mixedAxes();
    for (int axis = 0; axis < 3; ++axis) {
        const bool turns = (mixed & axisBit(axis)) != 0 && (named & mixed) != 0;
        // Without a rotation, an axis without a word keeps its position to the last bit.
        if (turns || (named & axisBit(axis)) != 0)
            motion.end[axis] = machine[axis];
    }
    motion.endKnown = bitsThatTurn(frame, known);
    forgetUnplaced(execution, motion);
    motion.endAtReference = motion.endAtReference && (motion.endKnown & kAxisZ) == 0;
    return motion;
}

bool onlySelectsMode(const Execution& execution) {
    const bool moves = execution.dialect.codeAloneMoves && execution.state.known == kAllAxes;
    return !moves && !execution.block.letters().any(LetterSet("XYZ@^"));
}

void reportMissingFeed(Execution& execution, const Word& word) {
    MachineState& state = execution.state;
    const bool inverse = state.feedMode == FeedMode::inverseTime;
    if (inverse && !execution.block.has('F'))
        execution.reporter.report(nc_message::kInverseTimeFeed, word);
    if (inverse || state.missingFeedReported)
        return;
    const bool isStopped = state.feedMode == FeedMode::perRevolution && state.feed > 0 &&
                           (state.spindleDirection == 0 || state.rpm() <= 0);
    state.missingFeedReported = state.feed <= 0 || isStopped;
    if (state.missingFeedReported)
        execution.reporter.report(isStopped ? nc_message::kFeedWithoutSpindle : nc_message::kNoFeed, word);
}

void reportUnknownStart(Execution& execution, const Motion& motion, const Word& word) {
    const auto unknown =
        static_cast<std::uint8_t>(kAllAxes & ~static_cast<unsigned>(motion.startKnown & motion.endKnown));
    if ((unknown & ~execution.state.unknownReported) == 0)
        return;
    execution.state.unknownReported |= unknown;
    execution.reporter.report(nc_message::kStartUnknown, word, {namesOfAxes(unknown)});
}

} // namespace proveout
