// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace proveout::bench {

/// Interprets one generated program of 22 MB and 1.05 million blocks, and lets LinuxCNC's stand-alone
/// interpreter (`rs274` of the Debian package linuxcnc-uspace) list the same file where it is installed.
/// Prints lines per second of both, least CPU seconds of several runs in turns, reading of the file included,
/// and the resident memory that a motion takes beside the text. False where that is more than the design
/// allows, or where the two do not make the same number of motions. Call it first: memory is measured on a
/// fresh heap.
[[nodiscard]] bool compareInterpreters();

} // namespace proveout::bench
