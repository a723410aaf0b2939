// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace proveout {

/// What playback keeps uniform: every block takes the same time, every millimetre of path does, or blocks
/// take the machine time.
enum class PlayBy : std::uint8_t { blocks, length, time };

/// Speeds are shown as multiples of this many blocks per second.
inline constexpr double kUnitBlocksPerSecond = 50;
/// The unit of speed in each mode: blocks, millimetres or seconds of machine time per second.
[[nodiscard]] constexpr double unitSpeed(PlayBy by) {
    return by == PlayBy::time ? 1 : kUnitBlocksPerSecond;
}

/// The state of playback. Value type.
struct Playback {
    bool playing = false;
    PlayBy by = PlayBy::blocks;
    double unitsPerSecond = kUnitBlocksPerSecond; ///< infinity: as fast as possible
    bool everyBlock = false; ///< paper mode: every block is drawn before the next one is cut

    friend bool operator==(const Playback&, const Playback&) = default;
};

} // namespace proveout
