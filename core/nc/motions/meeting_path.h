// SPDX-License-Identifier: GPL-3.0-or-later
// Cutter compensation by the points where the offset paths meet, as in LinuxCNC, Mach3 and RS274/NGC. Source:
// LinuxCNC user manual, cutter radius compensation.
#pragma once

#include "core/nc/motions/compensated_motion.h"

namespace proveout {

/// At an inside corner, the end of the previous motion moves to where both offset paths meet; at an outside
/// corner, the tool rolls around the programmed point.
class MeetingPath final : public CompensatedMotion {
public:
    using CompensatedMotion::CompensatedMotion;

    void finishHeld() override;

private:
    void enter() override;
    void join() override;
    void appendAcross() override;

    void joinInside(const PlanePath& path);
    bool finish(const Vec2& end, bool noticed);
    void appendCorner(const Vec2& end, double sweep);
    void emit(const PlanePath& path, const Vec2& from);
    void reportGouge(const FindingRow& message);

    [[nodiscard]] double radius() const;
    [[nodiscard]] Vec2 tip() const;
};

} // namespace proveout
