// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace proveout::bench {

/// Interprets one generated program of 22 MB and 1.05 million blocks, and runs LinuxCNC's stand-alone
/// interpreter (`rs274` of the Debian package linuxcnc-uspace) on the same file if it is installed. Prints
/// lines per second of both, from the lowest CPU time of several alternating runs including reading of the
/// file, and the resident memory per motion in addition to the text. False if that exceeds the design limit,
/// or if the numbers of motions differ. Call it first, because memory is measured on a fresh heap.
[[nodiscard]] bool compareInterpreters();

} // namespace proveout::bench
