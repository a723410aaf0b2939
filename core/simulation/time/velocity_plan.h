// SPDX-License-Identifier: GPL-3.0-or-later
// The speed of a machine along its path, with as much look-ahead as braking needs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/geometry.h"

namespace proveout {

/// A smooth piece of the path, longer than nothing. mm, s.
struct PathPiece {
    double length = 0;
    double topSpeed = 0;
    double acceleration = 0; ///< along the path, of braking too
    Vec3 startDirection{0};  ///< of unit length
    Vec3 endDirection{0};
    bool straight = true;
    std::uint32_t owner = 0; ///< handed back with the time
};

/// Plans the fastest speed that keeps to the top speeds, the accelerations and the limits of the corners,
/// from standstill to standstill. A corner is passed as fast as an arc within `cornerDeviation` of it allows
/// (junction deviation), and no faster than an arc through the middles of its straight sides (the limit of
/// polylines that stand for curves). Straight pieces in one direction are one side, however many they are, so
/// that cutting a piece in two changes no time. Takes O(1) a piece, and memory for as many as braking from
/// their speeds reaches over. One thread.
class VelocityPlan {
public:
    using Reported = std::function<void(std::uint32_t owner, double seconds)>;
    /// `told` is called for every piece in their order, later.
    VelocityPlan(double cornerDeviation, Reported reported);

    void add(const PathPiece& piece);
    /// The machine stands still here; the times of all pieces before are told.
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
    std::vector<Planned> m_pieces; ///< whose times were not told yet
    std::vector<double> m_entry;   ///< squared speeds at their starts and at the end of the last
    PathPiece m_last;
    std::size_t m_side = 0; ///< where the straight side begins that the last piece belongs to
    double m_sideLength = 0;
    double m_sideBefore = 0; ///< length of the one before
    double m_sideCorner = 0; ///< the tangent of half the angle between the two; infinite where straight on
    double m_sideAcceleration = 0; ///< at that corner
    std::size_t m_watch = 0;       ///< pieces at which the next look for sure ones is worth it
};

} // namespace proveout
