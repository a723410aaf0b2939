// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace proveout {

/// From now on a write that exceeds a limit on the size of files (SIGXFSZ), or that goes into a pipe without
/// a reader (SIGPIPE), fails with an error that can be reported; otherwise it would end the process without a
/// message. Call it once, at the start of a process, before its threads.
void reportFailedWrites();

} // namespace proveout
