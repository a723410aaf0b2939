// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/state/work_systems.h"

#include "core/nc/state/offset_parameters.h"

namespace proveout {

namespace {

constexpr int kFirstAdditional = 14001;
constexpr int kLastAdditional = 20'000;
constexpr int kFirstOfOld = 7001; ///< the first 48 of them a second time
constexpr int kLastOfOld = 7960;
constexpr int kLastStandard = 5340;

} // namespace

int systemVariable(int system) {
    return system <= kStandardSystems
               ? offsetParameter(system)
               : kFirstAdditional + kParametersPerOffset * (system - kStandardSystems - 1);
}

bool isWorkOffset(int variable) {
    return (variable >= kCommonOffset && variable <= kLastStandard) ||
           (variable >= kFirstOfOld && variable <= kLastOfOld) ||
           (variable >= kFirstAdditional && variable <= kLastAdditional);
}

void refreshFrame(MachineState& state, const Parameters& parameters, Program& program, std::uint32_t line) {
    WorkFrame frame = state.frame;
    frame.offset =
        vectorAt(parameters, kCommonOffset) + vectorAt(parameters, systemVariable(state.workOffset));
    frame.shift = state.presetShift + state.localShift;
    if (frame == state.frame)
        return;
    state.frame = frame;
    program.append(WorkOffset{state.workOffset, frame.zero()}, line);
}

} // namespace proveout
