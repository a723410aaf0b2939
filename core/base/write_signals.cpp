// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/write_signals.h"

#include <csignal>

namespace proveout {

void reportFailedWrites() {
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
}

} // namespace proveout
