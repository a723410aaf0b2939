// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace proveout {

/// What is even in playback: each block takes the same time, each millimetre of path, or what the machine
/// takes.
enum class PlayBy : std::uint8_t { blocks, length, time };

/// Speeds are told to people as multiples of this many blocks a second.
inline constexpr double kUnitBlocksPerSecond = 50;
/// The same of each way to play: blocks, millimetres, seconds of the machine a second.
[[nodiscard]] constexpr double unitSpeed(PlayBy by) {
    return by == PlayBy::time ? 1 : kUnitBlocksPerSecond;
}

/// How the program is played. Value type.
struct Playback {
    bool playing = false;
    PlayBy by = PlayBy::blocks;
    double unitsPerSecond = kUnitBlocksPerSecond; ///< infinity: as fast as possible
    bool everyBlock = false; ///< paper mode: every block is drawn before the next one is cut

    friend bool operator==(const Playback&, const Playback&) = default;
};

} // namespace proveout
