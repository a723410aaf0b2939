// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the material left above a head that is wider than its neck. A z-map has one height per place:
// cutting removes everything above the head from it, and this computes how much of that is still there in
// reality.
#pragma once

#include <optional>
#include <stop_token>

#include "core/base/geometry.h"
#include "core/base/index_rect.h"
#include "core/cutter/cutter.h"
#include "core/nc/program/motion.h"
#include "core/zmap/zmap.h"

namespace proveout {

struct Overhang {
    double volumeMm3 = 0; ///< that the z-map has lost but the stock still has
    double height = 0;    ///< the largest height of it over one point, mm
    Vec3 place{0};        ///< its lower end at that point, program coordinates
    double neckDepth = 0; ///< the deepest material that the neck went through above the head, mm

    void add(const Overhang& other);
};

/// Measures what `motion` of a cutter with a head left above it: what the z-map lost between the two
/// snapshots, less what head and neck swept. `changed`: the points that were lowered. Straight motions are
/// measured exactly; of arcs, each eighth of a turn is treated as one. Any thread; nothing if it was stopped,
/// which takes effect within some 30 ms.
[[nodiscard]] std::optional<Overhang> overhangLeft(const ZMapSnapshot& before, const ZMapSnapshot& after,
                                                   const IndexRect& changed, const Cutter& cutter,
                                                   const Motion& motion, const std::stop_token& stop);

} // namespace proveout
