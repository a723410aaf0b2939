// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/nc/program/program.h"
#include "core/simulation/run/program_reading.h"

namespace proveout::cli {

/// The memory of a program that is cut, in addition to its z-map. A value.
struct ProgramMemory {
    bool isCutWhileRead = false;
    double reading = 0; ///< bytes at most while it is read: the text, and the program while it grows
    double held = 0;    ///< bytes once it is read, with the records and times of its blocks

    /// The largest number of bytes of a run whose map, with what is made from it, needs so many.
    [[nodiscard]] double with(double mapBytes) const;
};

/// `program`: the whole program, or the beginning that `reading` returned last; then the rest is expected to
/// be like it.
[[nodiscard]] ProgramMemory programMemory(const ProgramReading& reading, const Program& program,
                                          bool isCutWhileRead);

} // namespace proveout::cli
