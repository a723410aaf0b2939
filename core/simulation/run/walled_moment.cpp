// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/run/walled_moment.h"

#include "core/simulation/run/rim_finder.h"
#include "core/zmap/wall_volume.h"

namespace proveout {

void addWalls(Frame& moment, const ZMapSnapshot* uncut) {
    RimFinder rims; // the second time, it looks at the tiles that were cut alone
    if (uncut != nullptr) {
        Frame before = moment;
        before.block = 0;
        before.zmap = *uncut;
        moment.removedMm3 += volumeAtWalls(rims.find(before));
    }
    moment.zmap = rims.find(moment);
    moment.removedMm3 -= volumeAtWalls(moment.zmap);
}

} // namespace proveout
