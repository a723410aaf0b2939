// SPDX-License-Identifier: GPL-3.0-or-later
// The envelope by brute force, implemented independently of the kernels: dense samples of the path and the
// positions where pieces of the profile meet, with each local minimum of the distance and of the height
// refined by golden section search.
#pragma once

#include <vector>

#include "core/cutter/cutter.h"
#include "core/nc/program/motion.h"

namespace proveout {

struct OracleHeight {
    double z;   ///< absolute; +infinity where the cutter never passes
    bool onRim; ///< the nearest position of the path is within 2e-5 mm of the rim or of another vertical wall
                ///< of the profile: not comparable
};

/// The positions of the tip, from a second implementation of the formula in motion.h.
class OraclePath {
public:
    /// With the given number of evenly spaced samples from 0 to 1, computed once for all points.
    OraclePath(const Motion& motion, int samples);

    [[nodiscard]] Vec3 at(double t) const;
    [[nodiscard]] const std::vector<Vec3>& samples() const { return m_samples; }

private:
    Motion m_motion;
    double m_radius = 0; ///< of an arc, followed by its start angle
    double m_widening = 0;
    double m_angle = 0;
    std::vector<Vec3> m_samples;
};

[[nodiscard]] Vec3 oraclePoint(const Motion& motion, double t);

[[nodiscard]] OracleHeight oracleEnvelope(const Cutter& cutter, const OraclePath& path, double x, double y);

} // namespace proveout
