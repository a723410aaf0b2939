// SPDX-License-Identifier: GPL-3.0-or-later
// One programmed motion beside which the cutter moves: what every control does alike with it.
#pragma once

#include <vector>

#include "core/nc/geometry/compensation.h"
#include "core/nc/state/execution.h"

namespace proveout {

/// Appends the path beside one programmed motion and joins it to the motion before. How the path enters and
/// leaves compensation and turns a corner depends on the control: a subclass adds that. An object lives as
/// long as the execution of one word.
class CompensatedMotion {
public:
    CompensatedMotion(Execution& execution, const Word& word, const Motion& motion);
    virtual ~CompensatedMotion() = default;
    CompensatedMotion(const CompensatedMotion&) = delete;
    CompensatedMotion& operator=(const CompensatedMotion&) = delete;

    /// Into compensation, in it, or out of it. The machine arrives at the programmed end.
    void append();
    /// The motion before is final: nothing that follows changes its end.
    virtual void finishHeld() = 0;

protected:
    virtual void enter() = 0;
    virtual void join() = 0;
    virtual void leave() = 0;
    /// Along the normal of the plane, or nowhere: the tip stays beside the same point.
    virtual void appendAcross() = 0;

    void report(const FindingRow& message, std::vector<Argument> arguments = {});
    /// Reports what the radius of the tool does not allow, and skips the motion.
    void refuse(const FindingRow& message, std::vector<Argument> arguments = {});
    void refuseSmallArc();

    /// The motion that is appended next may still change its end: `path` beside what was programmed, begun at
    /// `from`.
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

/// A length of a message, in mm.
[[nodiscard]] Argument shownLength(double length);

} // namespace proveout
