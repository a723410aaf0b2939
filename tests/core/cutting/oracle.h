// SPDX-License-Identifier: GPL-3.0-or-later
// The envelope by brute force, written without a look at the kernels: dense samples of the path and the
// places where pieces of the profile meet, each local minimum of the distance and of the height refined by
// golden section.
#pragma once

#include <vector>

#include "core/cutter/cutter.h"
#include "core/nc/program/motion.h"

namespace proveout {

struct OracleHeight {
    double z;   ///< absolute; +infinity where the cutter never comes
    bool onRim; ///< a nearest place of the path is within 2e-5 mm of the rim, or of another upright wall of
                ///< the profile: not to be compared
};

/// The places of the tip; the formula of the contract in motion.h, once more.
class OraclePath {
public:
    /// With so many samples, evenly from 0 to 1, taken once for all points.
    OraclePath(const Motion& motion, int samples);

    [[nodiscard]] Vec3 at(double t) const;
    [[nodiscard]] const std::vector<Vec3>& samples() const { return m_samples; }

private:
    Motion m_motion;
    double m_radius = 0; ///< of an arc, and its angle at the start
    double m_widening = 0;
    double m_angle = 0;
    std::vector<Vec3> m_samples;
};

[[nodiscard]] Vec3 oraclePoint(const Motion& motion, double t);

[[nodiscard]] OracleHeight oracleEnvelope(const Cutter& cutter, const OraclePath& path, double x, double y);

} // namespace proveout
