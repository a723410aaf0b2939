// SPDX-License-Identifier: GPL-3.0-or-later
// The speed of a machine along its path, with as much look-ahead as braking needs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/geometry.h"

namespace proveout {

/// A smooth piece of the path with a length above zero. mm, s.
struct PathPiece {
    double length = 0;
    double topSpeed = 0;
    double acceleration = 0; ///< along the path, also for braking
    Vec3 startDirection{0};  ///< unit vector
    Vec3 endDirection{0};
    bool straight = true;
    std::uint32_t owner = 0; ///< returned with the time
};

/// Plans the fastest speed that keeps to the top speeds, the accelerations and the limits of the corners,
/// from standstill to standstill. A corner is passed as fast as an arc within `cornerDeviation` of it permits
/// (junction deviation), and no faster than an arc through the middles of its straight sides (the limit for
/// polylines that approximate curves). Any number of straight pieces in one direction are one side, so that
/// splitting a piece changes no time. Needs O(1) time per piece, and memory for as many pieces as braking
/// from their speeds extends over. One thread.
class VelocityPlan {
public:
    using Reported = std::function<void(std::uint32_t owner, double seconds)>;
    /// `reported` is called later for every piece, in order.
    VelocityPlan(double cornerDeviation, Reported reported);

    void add(const PathPiece& piece);
    /// The machine stops here; the times of all earlier pieces are reported.
    void stop();

private:
    struct Planned {
        double length;
        double topSquared;
        double acceleration;
        double entryLimit; ///< squared, of the speed at its start
        std::uint32_t owner;
    };

    void closeSide();
    [[nodiscard]] double cornerLimit(const PathPiece& before, const PathPiece& after) const;
    void planBackward();
    void report(std::size_t count);
    void reportWhatIsSure();

    double m_cornerDeviation;
    Reported m_reported;
    std::vector<Planned> m_pieces; ///< whose times have not been reported yet
    std::vector<double> m_entry;   ///< squared speeds at their starts and at the end of the last
    PathPiece m_last;
    std::size_t m_side = 0; ///< start of the straight side that the last piece belongs to
    double m_sideLength = 0;
    double m_sideBefore = 0;       ///< length of the previous side
    double m_sideCorner = 0;       ///< the tangent of half the angle between the two; infinite if straight
    double m_sideAcceleration = 0; ///< at that corner
    std::size_t m_watch = 0;       ///< number of pieces at which the next search for final ones is worthwhile
};

} // namespace proveout
