// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace proveout {

/// From now on the calling thread yields to all others: with a busy processor it gets a few per cent of it.
/// There is no way back, so call it only in a thread of its own. Nothing happens where the system has no
/// priorities of threads.
void lowerThreadPriority();

} // namespace proveout
