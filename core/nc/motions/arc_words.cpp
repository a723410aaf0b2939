// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/motions/arc_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <optional>
#include <string>

#include "core/base/figures_argument.h"
#include "core/nc/geometry/arc.h"

namespace proveout {

namespace {

/// Beyond this radius a double cannot hold the centre to a nanometre of the path.
constexpr double kLargestRadius = 1e7;
/// An arc with a smaller radius has no direction; cutter compensation may leave such a small radius.
constexpr double kLeastRadius = 1e-6;
/// An arc flatter than this counts as a straight line for every user of the program.
constexpr double kFlat = 1e-6;

constexpr std::array<char, 3> kCentreLetters{'I', 'J', 'K'};

std::string letterOf(char letter) {
    return {letter};
}

/// The arc words of a block, in the plane in force.
class ArcWords {
public:
    ArcWords(Execution& execution, const Word& word, const Motion& program, bool clockwise)
        : m_execution(execution), m_word(word),
          m_plane(axes(program.plane)), m_ends{inPlane(program.start), inPlane(program.end), clockwise} {}

    /// Nothing, with a report, if the words do not make an arc.
    std::optional<Arc> read() {
        const bool radius = m_execution.block.has('R');
        const bool centre = has(m_plane.first) || has(m_plane.second);
        if (radius && m_execution.dialect.radiusWins)
            return ofRadius();
        if (has(m_plane.normal) && !(m_execution.dialect.streamed && centre && ignoresOffPlane()))
            return refuseOffPlane();
        if (radius && centre)
            return refuse(nc_message::kArcMixed, m_execution.block.word('R'));
        if (!radius && !centre) {
            return refuse(nc_message::kArcNoCentre, m_word,
                          {letterOf(firstLetter()), letterOf(secondLetter())});
        }
        return radius ? ofRadius() : aboutCentre();
    }

    /// Full turns beyond the first, by P.
    std::optional<int> extraTurns() {
        if (!m_execution.block.has('P') || !m_execution.state.motion->letters.has('P'))
            return 0;
        const Word& turns = m_execution.block.word('P');
        if (turns.value < 1 || turns.value > kMostTurns || turns.value != std::round(turns.value)) {
            m_execution.reporter.report(nc_message::kArcTurns, turns, {std::to_string(kMostTurns)});
            return {};
        }
        return static_cast<int>(turns.value) - 1;
    }

private:
    [[nodiscard]] static char letter(int axis) { return kCentreLetters[static_cast<std::size_t>(axis)]; }
    /// In alphabetical order, for messages.
    [[nodiscard]] char firstLetter() const { return letter(std::min(m_plane.first, m_plane.second)); }
    [[nodiscard]] char secondLetter() const { return letter(std::max(m_plane.first, m_plane.second)); }
    [[nodiscard]] bool has(int axis) const { return m_execution.block.has(letter(axis)); }
    [[nodiscard]] double value(int axis) const { return has(axis) ? m_execution.length(letter(axis)) : 0.0; }
    [[nodiscard]] Vec2 inPlane(const Vec3& point) const {
        return {point[m_plane.first], point[m_plane.second]};
    }

    /// If the dialect limits the difference of radii, lengths are also whole least increments.
    [[nodiscard]] ArcTolerances tolerances() const {
        const Dialect& dialect = m_execution.dialect;
        ArcTolerances result = arcTolerances(dialect.arcs, m_execution.state.inch);
        if (dialect.arcRadiiMm > 0) {
            result.difference = result.mostDifference = dialect.arcRadiiMm;
            result.samePoint = m_execution.leastLength() / 2;
        }
        return result;
    }

    std::optional<Arc> refuse(const FindingRow& message, const Word& word,
                              std::vector<Argument> arguments = {}) {
        m_execution.reporter.report(message, word, std::move(arguments));
        return {};
    }

    std::optional<Arc> refuseOffPlane() {
        constexpr std::array<const char*, 3> kPlaneCodes{"G19", "G18", "G17"};
        const char off = letter(m_plane.normal);
        return refuse(nc_message::kArcWrongWord, m_execution.block.word(off),
                      {letterOf(off), kPlaneCodes[static_cast<std::size_t>(m_plane.normal)]});
    }

    /// grbl reads the centre word of the third axis and ignores it.
    bool ignoresOffPlane() {
        const char off = letter(m_plane.normal);
        m_execution.reporter.report(nc_message::kArcWordIgnored, m_execution.block.word(off),
                                    {letterOf(off)});
        return true;
    }

    /// If the setting of the control determines whether I J K are absolute or incremental, reports when both
    /// make an arc.
    void reportOpenCentre() {
        MachineState& state = m_execution.state;
        if (!m_execution.dialect.arcCentreOpen || state.arcCentreChosen || state.arcCentreReported)
            return;
        const Vec2 absolute(value(m_plane.first), value(m_plane.second));
        const bool other = absolute != absolute + m_ends.start;
        if (!other || !arcAbout(absolute, m_ends, tolerances()))
            return;
        state.arcCentreReported = true;
        m_execution.reporter.report(nc_message::kArcCentreOpen, m_word);
    }

    std::optional<Arc> aboutCentre() {
        reportOpenCentre();
        Vec2 centre(value(m_plane.first), value(m_plane.second));
        if (!m_execution.state.arcCentreAbsolute)
            centre += m_ends.start;
        else if (!has(m_plane.first) || !has(m_plane.second))
            return refuse(nc_message::kArcCentreIncomplete, m_word,
                          {letterOf(firstLetter()), letterOf(secondLetter())});
        const int shown = has(m_plane.first) ? m_plane.first : m_plane.second;
        return checked(arcAbout(centre, m_ends, tolerances()), m_execution.block.word(letter(shown)));
    }

    std::optional<Arc> ofRadius() {
        if (m_execution.dialect.radiusNotScaled && m_execution.state.frame.transformation.scaled)
            m_execution.reporter.report(nc_message::kRadiusScaled, m_execution.block.word('R'), {"R"});
        const Word& word = m_execution.block.word('R');
        return checked(arcOfRadius(m_execution.length('R'), m_ends, tolerances()), word);
    }

    std::optional<Arc> checked(const tl::expected<Arc, ArcProblem>& arc, const Word& word) {
        if (arc)
            return *arc;
        const ArcProblem& problem = arc.error();
        const Argument first = figures("{:.6g}", problem.startRadius);
        const Argument second = figures("{:.6g}", problem.endRadius);
        const double difference = std::abs(problem.startRadius - problem.endRadius);
        switch (problem.fault) {
        case ArcFault::zeroRadius:
            return refuse(nc_message::kArcZeroRadius, word,
                          {figures("{:.6g}", std::min(problem.startRadius, problem.endRadius))});
        case ArcFault::endsDiffer:
            return refuse(nc_message::kArcEndsDiffer, word, {first, second, figures("{:.6g}", difference)});
        case ArcFault::fullWithRadius:
            return refuse(nc_message::kArcFullWithRadius, word);
        case ArcFault::radiusSmall:
            return refuse(
                nc_message::kArcRadiusSmall, word,
                {first, figures("{:.6g}", 2 * problem.endRadius), figures("{:.6g}", 2 * difference)});
        }
        return {};
    }

    Execution& m_execution;
    const Word& m_word;
    PlaneAxes m_plane;
    ArcEnds m_ends;
};

} // namespace

bool fitForSize(Execution& execution, const Word& word, Motion& motion) {
    const double radius = arcRadius(motion);
    if (radius < kLeastRadius) {
        execution.reporter.report(nc_message::kArcZeroRadius, word, {figures("{:.6g}", radius)});
        return false;
    }
    if (radius <= kLargestRadius) {
        if (withinLimits(motion))
            return true;
        execution.reporter.report(nc_message::kArcTooLong, word,
                                  {figures("{:.6g}", pathLength(motion)), figures("{:g}", kLongestArc)});
        return false;
    }
    if (std::abs(motion.sweep) < 1 && sagitta(radius, motion.sweep) < kFlat) {
        motion.kind = MotionKind::feed;
        return true;
    }
    execution.reporter.report(nc_message::kArcTooLarge, word, {figures("{:.6g}", radius)});
    return false;
}

bool readArc(Execution& execution, const Word& word, Motion& program, bool clockwise) {
    ArcWords words(execution, word, program, clockwise);
    const std::optional<Arc> arc = words.read();
    const std::optional<int> turns = arc ? words.extraTurns() : std::nullopt;
    if (!arc || !turns)
        return false;
    const PlaneAxes plane = axes(program.plane);
    program.centre = program.start;
    program.centre[plane.first] = arc->centre.x;
    program.centre[plane.second] = arc->centre.y;
    program.sweep = arc->sweep + std::copysign(2 * std::numbers::pi * *turns, arc->sweep);
    return true;
}

bool shapeArc(Execution& execution, const Word& word, Motion& motion, bool clockwise) {
    const WorkFrame& frame = execution.state.frame;
    const Transformation& transformation = frame.transformation;
    if (!transformation.keepsPlane(motion.plane) || !transformation.keepsCircles(motion.plane)) {
        execution.reporter.report(
            transformation.keepsPlane(motion.plane) ? nc_message::kArcScaled : nc_message::kArcTurned, word);
        return false;
    }
    Motion program = motion;
    program.start = frame.toProgram(motion.start);
    program.end = frame.toProgram(motion.end);
    if (!readArc(execution, word, program, clockwise))
        return false;
    const PlaneAxes plane = axes(motion.plane);
    motion.centre = frame.toMachine(program.centre);
    motion.centre[plane.normal] = motion.start[plane.normal];
    motion.sweep = transformation.flips(motion.plane) ? -program.sweep : program.sweep;
    return fitForSize(execution, word, motion);
}

} // namespace proveout
