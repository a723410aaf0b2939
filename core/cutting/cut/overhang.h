// SPDX-License-Identifier: GPL-3.0-or-later
// What stays above a head that is wider than its neck. A z-map has one height a place: there cutting takes
// away all that lies above the head, and this tells how much of it is still there in truth.
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
    double volumeMm3 = 0; ///< that the z-map has lost and the stock has not
    double height = 0;    ///< the most of it over one point, mm
    Vec3 place{0};        ///< its lower end at that point, program coordinates
    double neckDepth = 0; ///< the most that the neck went through above the head, mm

    void add(const Overhang& other);
};

/// Measures what `motion` of a cutter with a head left above it: what the z-map lost between the two moments,
/// less what head and neck swept. `changed`: the points that became lower. Straight motions exactly, of arcs
/// each eighth of a turn as one. Any thread; nothing where it was stopped, which is answered within some 30
/// ms.
[[nodiscard]] std::optional<Overhang> overhangLeft(const ZMapSnapshot& before, const ZMapSnapshot& after,
                                                   const IndexRect& changed, const Cutter& cutter,
                                                   const Motion& motion, const std::stop_token& stop);

} // namespace proveout
