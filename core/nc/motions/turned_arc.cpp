// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/motions/turned_arc.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "core/nc/motions/arc_words.h"
#include "core/nc/motions/motion_sink.h"

namespace proveout {

namespace {

/// The angle whose chord is within `sagitta` of an arc.
double angleOfSagitta(double radius, double sagitta) {
    constexpr double kWidest = std::numbers::pi / 6;
    if (radius <= sagitta)
        return kWidest;
    return std::min(kWidest, 2 * std::acos(1 - sagitta / radius));
}

} // namespace

double pieceCountOfArc(const Motion& arc, double chordError) {
    constexpr double kForTheArc = 0.9;
    const PlaneAxes plane = axes(arc.plane);
    const Vec3 toEnd = arc.end - arc.centre;
    const double radius = std::max(arcRadius(arc), std::hypot(toEnd[plane.first], toEnd[plane.second]));
    const double angle = angleOfSagitta(radius, kForTheArc * chordError);
    return std::max(1.0, std::ceil(std::abs(arc.sweep) / angle));
}

std::vector<Vec3> piecesOfArc(const Motion& arc, double chordError) {
    const auto count = static_cast<std::size_t>(pieceCountOfArc(arc, chordError));
    std::vector<Vec3> ends;
    ends.reserve(count);
    for (std::size_t i = 1; i <= count; ++i)
        ends.push_back(pointAt(arc, static_cast<double>(i) / static_cast<double>(count)));
    return ends;
}

bool turnsPlane(const WorkFrame& frame, Plane plane) {
    return frame.rotation != 0 && plane != Plane::xy;
}

bool appendTurnedArc(Execution& execution, const Word& word, const Motion& motion, bool clockwise) {
    const WorkFrame& frame = execution.state.frame;
    Motion program = motion;
    program.start = frame.toProgram(motion.start);
    program.end = frame.toProgram(motion.end);
    if (!readArc(execution, word, program, clockwise) || !fitForSize(execution, word, program))
        return false;
    std::vector<Vec3> ends{motion.end};
    if (program.kind == MotionKind::arc) {
        if (!execution.mayMake(pieceCountOfArc(program, kChordError), word))
            return false;
        ends = piecesOfArc(program, kChordError);
        std::ranges::transform(ends, ends.begin(), [&](const Vec3& end) { return frame.toMachine(end); });
        ends.back() = motion.end;
    }
    appendPieces(execution, motion, ends);
    return true;
}

} // namespace proveout
