// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/motion_building.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "core/nc/polar_words.h"
#include "core/nc/transformation_codes.h"

namespace proveout {

namespace {

constexpr std::array<char, 3> kAxisLetters{'X', 'Y', 'Z'};

std::uint8_t bit(int axis) {
    return static_cast<std::uint8_t>(1U << static_cast<unsigned>(axis));
}

} // namespace

std::string namesOfAxes(std::uint8_t axes) {
    std::string names;
    for (int axis = 0; axis < 3; ++axis) {
        if ((axes & bit(axis)) == 0)
            continue;
        names += names.empty() ? "" : ", ";
        names += kAxisLetters[static_cast<std::size_t>(axis)];
    }
    return names;
}

namespace {

/// The feed, as far as it does not depend on the length of the path.
void setFeed(Motion& motion, const MachineState& state) {
    motion.perRevolution = state.feedMode == FeedMode::perRevolution;
    if (motion.perRevolution)
        motion.feedMmPerMin = state.feed * std::abs(motion.spindleRpm);
    else if (state.feedMode == FeedMode::perMinute)
        motion.feedMmPerMin = state.feed;
}

} // namespace

Vec3 tipAt(const Execution& execution, const Vec3& programmed) {
    const Vec3 displacement = execution.state.compensation.displacement + execution.state.strayed;
    if (displacement == Vec3(0))
        return programmed;
    constexpr double kRounding = 1e-9; ///< of adding and subtracting the displacement
    const Vec3 tip = programmed + displacement;
    const std::size_t count = execution.program.motionCount();
    if (count == 0)
        return tip;
    const Vec3 last = execution.program.endOf(count - 1);
    return glm::distance(tip, last) < kRounding ? last : tip;
}

void goOnFromTip(Execution& execution) {
    MachineState& state = execution.state;
    state.position = tipAt(execution, state.position);
    state.compensation.displacement = state.strayed = Vec3(0);
}

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
        motion.endKnown |= bit(axis);
        return;
    }
    motion.endKnown &= static_cast<std::uint8_t>(~bit(axis));
    constexpr int kZ = 2;
    if (axis == kZ)
        motion.endAtReference = value == 0;
    if (!state.referenceTold) {
        state.referenceTold = true;
        execution.reporter.tell(nc_message::kReferenceUnknown, 1, 0,
                                {std::string(1, kAxisLetters[static_cast<std::size_t>(axis)])});
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
        execution.reporter.tell(nc_message::kIncrementalUnknown, word, {std::string(1, word.letter)});
        return {};
    }
    if ((incremental || !block.has('^')) && program.x == 0 && program.y == 0) {
        const Word& word = block.word(block.has('@') ? '@' : '^');
        execution.reporter.tell(nc_message::kPolarOrigin, word, {std::string(1, word.letter)});
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

/// The program coordinate that the word of an axis orders; false where it counts from an unknown place.
bool axisTarget(Execution& execution, int axis, std::uint8_t known, Vec3& program) {
    MachineState& state = execution.state;
    const char letter = kAxisLetters[static_cast<std::size_t>(axis)];
    const double value = execution.length(letter);
    if (!state.incremental) {
        program[axis] = value;
        return true;
    }
    if ((known & bit(axis)) != 0) {
        program[axis] += value;
        return true;
    }
    if ((state.unknownTold & bit(axis)) == 0) {
        state.unknownTold |= bit(axis);
        execution.reporter.tell(nc_message::kIncrementalUnknown, execution.block.word(letter),
                                {std::string(1, letter)});
    }
    return false;
}

/// Under a rotation, the machine's place along an axis depends on more than its own word.
std::uint8_t bitsThatTurn(const WorkFrame& frame, std::uint8_t bits) {
    const std::uint8_t mixed = frame.mixedAxes();
    return (bits & mixed) != mixed ? static_cast<std::uint8_t>(bits & ~mixed) : bits;
}

/// AxisBits of what the axis words of the block order in program coordinates.
std::uint8_t readAxisWords(Execution& execution, Motion& motion, std::uint8_t known, Vec3& program) {
    const MachineState& state = execution.state;
    std::uint8_t named = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const char letter = kAxisLetters[static_cast<std::size_t>(axis)];
        if (!execution.block.has(letter))
            continue;
        if (execution.machineCoordinates)
            setMachineTarget(execution, motion, axis, execution.length(letter) - state.toolOffset[axis]);
        else if (state.polar.on && axis != axes(state.plane).normal)
            continue;
        else if (axisTarget(execution, axis, known, program))
            named |= bit(axis);
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

/// A transformation about an unknown centre leads to unknown places.
void forgetUnplaced(const Execution& execution, Motion& motion) {
    if (!execution.machineCoordinates)
        motion.endKnown &= static_cast<std::uint8_t>(~execution.state.frame.transformation.unplacedAxes());
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
        tellTurning(execution, named);
    const Vec3 machine = frame.toMachine(program);
    const std::uint8_t mixed = frame.mixedAxes();
    for (int axis = 0; axis < 3; ++axis) {
        const bool turns = (mixed & bit(axis)) != 0 && (named & mixed) != 0;
        // Where nothing turns, an axis without a word keeps its place to the last bit.
        if (turns || (named & bit(axis)) != 0)
            motion.end[axis] = machine[axis];
    }
    motion.endKnown = bitsThatTurn(frame, known);
    forgetUnplaced(execution, motion);
    motion.endAtReference = motion.endAtReference && (motion.endKnown & kAxisZ) == 0;
    return motion;
}

bool planeKnown(const Motion& motion) {
    const PlaneAxes plane = axes(motion.plane);
    const auto needed = static_cast<std::uint8_t>(bit(plane.first) | bit(plane.second));
    return (motion.startKnown & motion.endKnown & needed) == needed;
}

bool onlySelectsMode(const Execution& execution) {
    const bool moves = execution.dialect.codeAloneMoves && execution.state.known == kAllAxes;
    return !moves && !execution.block.letters().any(LetterSet("XYZ@^"));
}

void tellMissingFeed(Execution& execution, const Word& word) {
    MachineState& state = execution.state;
    const bool inverse = state.feedMode == FeedMode::inverseTime;
    if (inverse && !execution.block.has('F'))
        execution.reporter.tell(nc_message::kInverseTimeFeed, word);
    if (inverse || state.missingFeedTold)
        return;
    const bool stands = state.feedMode == FeedMode::perRevolution && state.feed > 0 &&
                        (state.spindleDirection == 0 || state.rpm() <= 0);
    state.missingFeedTold = state.feed <= 0 || stands;
    if (state.missingFeedTold)
        execution.reporter.tell(stands ? nc_message::kFeedWithoutSpindle : nc_message::kNoFeed, word);
}

void tellUnknownStart(Execution& execution, const Motion& motion, const Word& word) {
    const auto unknown =
        static_cast<std::uint8_t>(kAllAxes & ~static_cast<unsigned>(motion.startKnown & motion.endKnown));
    if ((unknown & ~execution.state.unknownTold) == 0)
        return;
    execution.state.unknownTold |= unknown;
    execution.reporter.tell(nc_message::kStartUnknown, word, {namesOfAxes(unknown)});
}

void arrive(MachineState& state, const Motion& motion) {
    state.position = motion.end;
    state.known = motion.endKnown;
    state.zAtReference = motion.endAtReference;
    state.everKnown |= motion.endKnown;
    state.unknownTold &= static_cast<std::uint8_t>(~state.known);
}

void leaveOut(Execution& execution, const Motion& motion) {
    execution.state.compensation.beginAnew();
    arrive(execution.state, motion);
}

namespace {

/// The feed of G93 for a path of a length in mm.
double inverseTimeFeed(const Execution& execution, double length) {
    const MachineState& state = execution.state;
    if (!execution.block.has('F'))
        return 0;
    return std::max(state.feed * length, state.toMm(execution.dialect.leastInverseFeed));
}

} // namespace

void setInverseTimeFeed(const Execution& execution, Motion& motion) {
    if (motion.kind != MotionKind::rapid && execution.state.feedMode == FeedMode::inverseTime)
        motion.feedMmPerMin = inverseTimeFeed(execution, pathLength(motion));
}

void appendMotion(Execution& execution, Motion motion) {
    const Vec3 ahead =
        execution.dialect.inverseTimeAsProgrammed ? Vec3(0) : execution.state.compensation.displacement;
    motion.start += ahead;
    setInverseTimeFeed(execution, motion);
    motion.start -= ahead;
    appendWithFeed(execution, motion);
}

namespace {

/// Scaling and repetition make numbers larger than any that a text may hold. Where an axis would go that far
/// is not known any more, so that what comes after is computed from places that can be.
void forgetTooFar(Execution& execution, Motion& motion) {
    constexpr double kFarthest = 1e14; ///< mm; squares of it, and sums of them, are far from overflowing
    std::uint8_t beyond = 0;
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(motion.end[axis]) <= kFarthest)
            continue;
        beyond |= bit(axis);
        motion.end[axis] = motion.start[axis];
    }
    if (beyond == 0)
        return;
    motion.endKnown &= static_cast<std::uint8_t>(~static_cast<unsigned>(beyond));
    if (motion.kind == MotionKind::arc)
        motion.kind = MotionKind::feed;
    execution.reporter.tell(nc_message::kTargetTooFar, 1, 0, {"1e14", namesOfAxes(beyond)});
}

} // namespace

void appendWithFeed(Execution& execution, Motion motion) {
    motion.start = tipAt(execution, motion.start);
    execution.state.compensation.displacement = execution.state.strayed = Vec3(0);
    forgetTooFar(execution, motion);
    motion.unverified = execution.reporter.unverified();
    forgetUnplaced(execution, motion);
    execution.program.append(motion);
    arrive(execution.state, motion);
}

void appendPieces(Execution& execution, const Motion& whole, const std::vector<Vec3>& ends) {
    const MachineState& state = execution.state;
    Motion piece = whole;
    piece.kind = MotionKind::feed;
    if (state.feedMode == FeedMode::inverseTime) {
        double length = 0;
        Vec3 last = whole.start;
        for (const Vec3& end : ends) {
            length += glm::distance(last, end);
            last = end;
        }
        piece.feedMmPerMin = inverseTimeFeed(execution, length);
    }
    for (const Vec3& end : ends) {
        piece.start = state.position;
        piece.end = end;
        appendWithFeed(execution, piece);
        piece.startKnown = whole.endKnown;
        if (execution.mustEnd())
            return;
    }
}

void appendOrdered(Execution& execution, const Word& word, const Motion& motion) {
    const CutterCompensation& compensation = execution.state.compensation;
    if (compensation.moves() || (execution.dialect.vectors.used && compensation.leaving()))
        appendCompensated(execution, word, motion);
    else
        appendMotion(execution, motion);
}

} // namespace proveout
