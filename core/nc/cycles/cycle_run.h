// SPDX-License-Identifier: GPL-3.0-or-later
// The holes of a canned cycle as motions.
#pragma once

#include "core/nc/codes/canned_cycle.h"
#include "core/nc/cycles/cycle_order.h"
#include "core/nc/program/motion.h"
#include "core/nc/state/execution.h"

namespace proveout {

/// Drills from where the tool stands; keeps references to all that it is given.
class CycleRun {
public:
    CycleRun(Execution& execution, const Word& word, const CannedCycle& cycle, const CycleOrder& order);

    /// Whether a block may have so many of these holes; told where not.
    [[nodiscard]] bool mayDrill(double holes) const;
    /// The holes to which the axis words of the block lead.
    void drillBlock();
    /// One hole at a place in the plane, in program coordinates.
    void drillAt(const Vec2& place);

private:
    [[nodiscard]] const Block& block() const { return m_execution.block; }
    /// LinuxCNC lists motions and dwells of no length.
    [[nodiscard]] bool listsNothing() const { return m_execution.dialect.codeAloneMoves; }

    void lift();
    void drill();
    void apply(CycleStep step);
    void turn(int direction) { m_execution.state.spindleDirection = direction; }
    void dwell();
    [[nodiscard]] bool isAbove(double depth, double bottom) const;
    void peck(bool retract);
    [[nodiscard]] double above(double depth, double gap) const;
    void tap();
    void tapOut();
    void shift(const Vec3& offset);
    void backBore();
    void reportMixed();
    void feedMixed(double level);
    void startAsLeft();
    void moveOver();
    void depthTo(MotionKind kind, double level, double ratio = 1);
    void moveTo(MotionKind kind, const Vec3& program, bool depthKnown, double ratio = 1);
    [[nodiscard]] bool namedOnce(int axis) const;

    Execution& m_execution;
    const Word& m_word;
    const CannedCycle& m_cycle;
    CycleOrder m_order;
    PlaneAxes m_plane;
    Vec3 m_at;   ///< program coordinates
    Vec3 m_hole; ///< of the hole in work, in its plane
    bool m_depthKnown;
    double m_level;       ///< at which the next hole is reached
    int m_turnBefore = 0; ///< of the spindle, before the hole
    int m_turn = 0;       ///< in the hole
};

} // namespace proveout
