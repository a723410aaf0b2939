// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/program_memory.h"

#include <algorithm>

#include "core/simulation/run/statistics.h"
#include "core/simulation/time/machine_time.h"

namespace proveout::cli {

double ProgramMemory::with(double mapBytes) const {
    return isCutWhileRead ? mapBytes + std::max(reading, held) : std::max(mapBytes + held, reading);
}

ProgramMemory programMemory(const ProgramReading& reading, const Program& program, bool isCutWhileRead) {
    constexpr double kOfBlock = sizeof(BlockStatistics) + MachineTimes::kBytesPerBlock;
    const double part = reading.partOf(program);
    const double motions = static_cast<double>(program.bytes()) / part;
    const double blocks = kOfBlock * static_cast<double>(program.blockCount()) / part;
    // As much again while it grows, and the beginning that is cut.
    const double growing = isCutWhileRead ? 3 * motions + blocks : 2 * motions;
    return {isCutWhileRead, static_cast<double>(reading.textBytes()) + growing, motions + blocks};
}

} // namespace proveout::cli
