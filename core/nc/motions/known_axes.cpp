// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/motions/known_axes.h"

namespace proveout {

void forgetAxes(MachineState& state, LetterSet axes, Forgotten why) {
    state.zAtReference = state.zAtReference && !axes.has('Z');
    for (int axis = 0; axis < 3; ++axis) {
        const bool polar = axis < 2 && axes.any(LetterSet("@^"));
        if (!axes.has(static_cast<char>('X' + axis)) && !polar)
            continue;
        const std::uint8_t bit = axisBit(axis);
        const auto rest = static_cast<std::uint8_t>(~bit);
        state.known &= rest;
        state.unknownReported &= rest;
        if (why == Forgotten::reported)
            state.unknownReported |= bit;
    }
}

} // namespace proveout
