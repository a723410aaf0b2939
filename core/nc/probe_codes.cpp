// SPDX-License-Identifier: GPL-3.0-or-later
// Probing: G38.2 to G38.5, and G31 of Fanuc. Where the probe meets the part, only the machine finds out.
#include "core/nc/execution.h"
#include "core/nc/handlers.h"
#include "core/nc/motion_building.h"

namespace proveout {

namespace {

constexpr int kContact = 5061; ///< X; the other axes that LinuxCNC knows follow
constexpr int kContactAxes = 9;
constexpr int kSuccess = 5070;

bool mayProbe(Execution& execution, const Word& word) {
    if (!execution.block.letters().any(LetterSet("XYZ@^"))) {
        execution.reporter.tell(nc_message::kWordMissing, word, {nameOf(word), "X / Y / Z"});
        return false;
    }
    if (execution.state.feedMode == FeedMode::perRevolution) {
        execution.reporter.tell(nc_message::kProbePerRevolution, word);
        return false;
    }
    return true;
}

/// The contact in program coordinates, in the unit of the program.
void storeContact(Execution& execution, const Motion& motion) {
    const Vec3 program = execution.state.frame.toProgram(motion.end);
    for (int axis = 0; axis < kContactAxes; ++axis) {
        const bool linear = axis < 3;
        execution.parameters.setNumbered(kContact + axis,
                                         linear ? execution.state.fromMm(program[axis]) : 0.0);
    }
    execution.parameters.setNumbered(kSuccess, 0);
}

} // namespace

void probe(Execution& execution, const Word& word) {
    if (!mayProbe(execution, word)) {
        arrive(execution.state, motionToTarget(execution, MotionKind::feed));
        return;
    }
    const Motion motion = motionToTarget(execution, MotionKind::feed);
    tellMissingFeed(execution, word);
    tellUnknownStart(execution, motion, word);
    if (motion.known() && motion.start == motion.end) {
        execution.reporter.tell(nc_message::kProbeTooClose, word);
        return;
    }
    if (!execution.state.probeTold) {
        execution.state.probeTold = true;
        execution.reporter.tell(nc_message::kProbeAssumed, word);
    }
    appendMotion(execution, motion);
    storeContact(execution, motion);
}

void skipMotion(Execution& execution, const Word& word) {
    const Motion motion = motionToTarget(execution, MotionKind::feed);
    tellMissingFeed(execution, word);
    tellUnknownStart(execution, motion, word);
    if (!execution.state.probeTold) {
        execution.state.probeTold = true;
        execution.reporter.tell(nc_message::kSkipAssumed, word);
    }
    appendMotion(execution, motion);
}

} // namespace proveout
