// SPDX-License-Identifier: GPL-3.0-or-later
// The envelope by brute force, written without a look at the kernels: dense samples of the path and the
// places where pieces of the profile meet, each local minimum of the distance and of the height refined by
// golden section.
#pragma once

#include "core/cutter/cutter.h"
#include "core/nc/motion.h"

namespace proveout {

struct OracleHeight {
    double z;   ///< absolute; +infinity where the cutter never comes
    bool onRim; ///< a nearest place of the path is within 2e-5 mm of the rim, or of another upright wall of
                ///< the profile: not to be compared
};

/// The place of the tip; the formula of the contract in motion.h, once more.
[[nodiscard]] Vec3 oraclePoint(const Motion& motion, double t);

[[nodiscard]] OracleHeight oracleEnvelope(const Cutter& cutter, const Motion& motion, double x, double y,
                                          int samples);

} // namespace proveout
