// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace proveout {

/// From now on a write that hits a limit on the size of files (SIGXFSZ) or a pipe that nobody reads (SIGPIPE)
/// fails with an error that can be reported, where it would else end the process without a word. Once, at the
/// start of a process, before its threads.
void reportFailedWrites();

} // namespace proveout
