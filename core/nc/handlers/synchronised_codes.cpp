// SPDX-License-Identifier: GPL-3.0-or-later
// Synchronized motions: G33, and rigid tapping by G33.1. The feed is pitch times spindle speed.
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/nc/codes/handlers.h"
#include "core/nc/motions/motion_sink.h"
#include "core/nc/motions/motion_target.h"
#include "core/nc/state/execution.h"

namespace proveout {

namespace {

bool refuse(Execution& execution, const FindingRow& message, const Word& word,
            std::vector<Argument> arguments = {}) {
    execution.reporter.report(message, word, std::move(arguments));
    return false;
}

bool wordsFit(Execution& execution, const Word& word) {
    execution.state.straightDue = false;
    const Block& block = execution.block;
    if (!block.letters().any(LetterSet("XYZ@^")))
        return refuse(execution, nc_message::kWordMissing, word, {nameOf(word), "X / Y / Z"});
    if (!block.has('K'))
        return refuse(execution, nc_message::kWordMissing, word, {nameOf(word), "K"});
    if (block.value('K') <= 0)
        return refuse(execution, nc_message::kPitch, block.word('K'));
    if (block.has('F'))
        return refuse(execution, nc_message::kSynchronisedFeed, block.word('F'), {nameOf(word)});
    const MachineState& state = execution.state;
    if (state.spindleDirection == 0 || state.rpm() <= 0)
        return refuse(execution, nc_message::kSynchronisedSpindle, word, {nameOf(word)});
    return true;
}

/// The motion to the target of the block, at the feed given by the pitch.
Motion motionInStep(Execution& execution, const Word& word) {
    Motion motion = motionToTarget(execution, MotionKind::feed);
    reportUnknownStart(execution, motion, word);
    motion.perRevolution = true;
    motion.feedMmPerMin = execution.length('K') * std::abs(motion.spindleRpm);
    return motion;
}

} // namespace

void moveInStep(Execution& execution, const Word& word) {
    if (wordsFit(execution, word))
        appendWithFeed(execution, motionInStep(execution, word));
    else
        arrive(execution.state, motionToTarget(execution, MotionKind::feed));
}

void tapRigidly(Execution& execution, const Word& word) {
    if (!wordsFit(execution, word))
        return;
    const Motion motion = motionInStep(execution, word);
    const Vec3 strayed = execution.state.strayed;
    const Vec3 displacement = execution.state.compensation.displacement;
    const Vec3 start = tipAt(execution, motion.start);
    appendWithFeed(execution, motion);
    // The spindle is reversed on the way out, faster by the factor I.
    Motion back = motionFromHere(execution, MotionKind::feed);
    back.end = start;
    back.endKnown = motion.startKnown;
    back.endAtReference = motion.startAtReference;
    const bool faster = execution.block.has('I') && execution.block.value('I') > 0;
    const double factor = faster ? execution.block.value('I') : 1;
    back.perRevolution = true;
    back.spindleRpm = -motion.spindleRpm * factor;
    back.feedMmPerMin = motion.feedMmPerMin * factor;
    appendWithFeed(execution, back);
    execution.state.position = motion.start;
    execution.state.strayed = strayed;
    execution.state.compensation.displacement = displacement;
}

} // namespace proveout
