// SPDX-License-Identifier: GPL-3.0-or-later
// One programmed motion with cutter compensation: the behaviour that all controls share.
#pragma once

#include <vector>

#include "core/nc/geometry/compensation.h"
#include "core/nc/state/execution.h"

namespace proveout {

/// Appends the offset path of one programmed motion and joins it to the motion before. How the path enters
/// and leaves compensation and turns a corner depends on the control: a subclass adds that. An object lives
/// as long as the execution of one word.
class CompensatedMotion {
public:
    CompensatedMotion(Execution& execution, const Word& word, const Motion& motion);
    virtual ~CompensatedMotion() = default;
    CompensatedMotion(const CompensatedMotion&) = delete;
    CompensatedMotion& operator=(const CompensatedMotion&) = delete;

    /// Enters compensation, stays in it, or leaves it. The machine arrives at the programmed end.
    void append();
    /// Makes the previous motion final: nothing that follows changes its end.
    virtual void finishHeld() = 0;

protected:
    /// The first motion that is not beside the path yet; or, after the end of compensation, no longer.
    virtual void enter() = 0;
    virtual void join() = 0;
    /// Moves along the normal of the plane, or not at all: the tip stays beside the same point.
    virtual void appendAcross() = 0;

    void report(const FindingRow& message, std::vector<Argument> arguments = {});
    /// Reports a motion that the tool radius does not permit, and skips it.
    void refuse(const FindingRow& message, std::vector<Argument> arguments = {});
    void refuseSmallArc();

    /// The motion that is appended next may still change its end: `path` is the offset of what was
    /// programmed, starting at `from`.
    void hold(const PlanePath& path, const Vec2& from);
    void append(Motion& motion, const Vec3& programmedEnd);

    Execution& m_execution;
    CutterCompensation& m_compensation;
    const Word& m_word;
    const Motion& m_motion;
    PlaneAxes m_plane;
    PlanePath m_programmed;

private:
    void appendUnknown();
};

/// A length in mm for a message.
[[nodiscard]] Argument shownLength(double length);

} // namespace proveout
