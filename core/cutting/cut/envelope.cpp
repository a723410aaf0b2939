// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/cut/cutting.h"
#include "core/cutting/cut/sweep.h"

namespace proveout {

double envelope(const Cutter& cutter, const Motion& motion, double x, double y) {
    return Sweep(cutter, motion, 0).envelope(x, y);
}

} // namespace proveout
