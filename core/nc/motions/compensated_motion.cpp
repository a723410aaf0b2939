// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/motions/compensated_motion.h"

#include <cmath>
#include <utility>

#include "core/base/figures_argument.h"
#include "core/nc/motions/arc_words.h"
#include "core/nc/motions/motion_sink.h"
#include "core/nc/motions/radius_notice.h"

namespace proveout {

Argument shownLength(double length) {
    return figures("{:.6g}", length);
}

CompensatedMotion::CompensatedMotion(Execution& execution, const Word& word, const Motion& motion)
    : m_execution(execution), m_compensation(execution.state.compensation), m_word(word), m_motion(motion),
      m_plane(axes(execution.state.plane)), m_programmed{inPlane(motion.start, m_plane),
                                                         inPlane(motion.end, m_plane),
                                                         inPlane(motion.centre, m_plane), motion.sweep} {}

void CompensatedMotion::append() {
    if (!planeKnown(m_motion))
        appendUnknown();
    else if (!m_programmed.arc() && glm::distance(m_programmed.start, m_programmed.end) < kNoLength)
        appendAcross();
    else if (!m_compensation.entered)
        enter();
    else
        join();
}

void CompensatedMotion::report(const FindingRow& message, std::vector<Argument> arguments) {
    m_execution.reporter.report(message, m_word, std::move(arguments));
}

void CompensatedMotion::refuse(const FindingRow& message, std::vector<Argument> arguments) {
    reportOfRadius(m_execution, message, m_word, std::move(arguments));
    skipMotion(m_execution, m_motion);
}

void CompensatedMotion::refuseSmallArc() {
    refuse(nc_message::kCompensationArcSmall,
           {shownLength(glm::distance(m_programmed.end, m_programmed.centre)),
            shownLength(std::abs(m_compensation.offset))});
}

void CompensatedMotion::hold(const PlanePath& path, const Vec2& from) {
    m_compensation.entered = m_compensation.held = true;
    m_compensation.entry = false;
    m_compensation.firstHeld = m_execution.program.motionCount();
    m_compensation.path = path;
    m_compensation.from = from;
}

void CompensatedMotion::append(Motion& motion, const Vec3& programmedEnd) {
    motion.unverified = m_execution.reporter.unverified();
    m_execution.program.appendCompensated(motion, programmedEnd);
}

void CompensatedMotion::appendUnknown() {
    if (!m_compensation.unknownReported)
        report(nc_message::kCompensationUnknownStart);
    m_compensation.unknownReported = true;
    restartCompensation(m_compensation);
    appendMotion(m_execution, m_motion);
}

} // namespace proveout
