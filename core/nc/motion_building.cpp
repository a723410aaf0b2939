// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/motion_building.h"

#include <array>
#include <string>

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

Motion motionToTarget(Execution& execution, MotionKind kind) {
    const MachineState& state = execution.state;
    Motion motion;
    motion.kind = kind;
    motion.plane = state.plane;
    motion.line = execution.line;
    motion.tool = state.tool;
    motion.spindleRpm = state.spindleDirection * state.spindleRpm;
    motion.orderedRpm = state.spindleRpm;
    motion.feedMmPerMin = kind == MotionKind::rapid ? 0 : state.feedMmPerMin;
    motion.start = motion.end = state.position;
    motion.startKnown = motion.endKnown = state.known;
    for (int axis = 0; axis < 3; ++axis) {
        const char letter = kAxisLetters[static_cast<std::size_t>(axis)];
        if (!execution.block.has(letter))
            continue;
        const double value = state.toMm(execution.block.value(letter));
        if (!state.incremental) {
            motion.end[axis] = value;
            motion.endKnown |= bit(axis);
        } else if ((state.known & bit(axis)) != 0) {
            motion.end[axis] += value;
        } else if ((state.unknownTold & bit(axis)) == 0) {
            execution.state.unknownTold |= bit(axis);
            execution.reporter.tell(nc_message::kIncrementalUnknown, execution.block.word(letter),
                                    {std::string(1, letter)});
        }
    }
    return motion;
}

bool onlySelectsMode(const Execution& execution) {
    return execution.state.known != kAllAxes && !execution.block.letters().any(LetterSet("XYZ"));
}

void tellMissingFeed(Execution& execution, const Word& word) {
    if (execution.state.feedMmPerMin > 0 || execution.state.missingFeedTold)
        return;
    execution.state.missingFeedTold = true;
    execution.reporter.tell(nc_message::kNoFeed, word);
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
    state.everKnown |= motion.endKnown;
    state.unknownTold &= static_cast<std::uint8_t>(~state.known);
}

void appendMotion(Execution& execution, Motion motion) {
    motion.unverified = execution.reporter.unverified();
    execution.program.append(motion);
    arrive(execution.state, motion);
}

} // namespace proveout
