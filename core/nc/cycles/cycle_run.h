// SPDX-License-Identifier: GPL-3.0-or-later
// The holes of a canned cycle as motions.
#pragma once

#include "core/nc/codes/canned_cycle.h"
#include "core/nc/cycles/cycle_order.h"
#include "core/nc/program/motion.h"
#include "core/nc/state/execution.h"

namespace proveout {

/// Drills from the present position of the tool; keeps references to all its arguments.
class CycleRun {
public:
    CycleRun(Execution& execution, const Word& word, const CannedCycle& cycle, const CycleOrder& order);

    /// Whether a block may have this many holes; reported if not.
    [[nodiscard]] bool mayDrill(double holes) const;
    /// Drills the holes that the axis words of the block give.
    void drillBlock();
    /// Drills one hole at a place in the plane, in program coordinates.
    void drillAt(const Vec2& place);

private:
    [[nodiscard]] const Block& block() const { return m_execution.block; }
    /// Whether motions and dwells of no length are listed, as LinuxCNC does.
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
    Vec3 m_hole; ///< of the current hole, in its plane
    bool m_depthKnown;
    double m_level;       ///< the level at which the next hole is approached
    int m_turnBefore = 0; ///< direction of the spindle before the hole
    int m_turn = 0;       ///< direction in the hole
};

} // namespace proveout
