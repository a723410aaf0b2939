// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/thread_priority.h"

#ifdef __linux__
#include <sys/resource.h>
#endif

namespace proveout {

void lowerThreadPriority() {
#ifdef __linux__
    constexpr int kNice = 15;                  // 36 of 1024 shares (sched(7))
    (void)setpriority(PRIO_PROCESS, 0, kNice); // on Linux of the calling thread alone
#endif
}

} // namespace proveout
