// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/time/machine_time.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

#include "core/simulation/time/velocity_plan.h"

namespace proveout {

namespace {

constexpr double kSecondsPerMinute = 60;
/// The largest component of an arc's direction along an axis is used for its whole length.
constexpr double kMovesAxis = 1e-12;
constexpr std::size_t kMotionsBetweenLooks = 4096;

struct AxisLimits {
    Vec3 speed;
    Vec3 acceleration;
};

/// The largest value along a direction that keeps every axis within its limit.
double along(const Vec3& direction, const Vec3& limits) {
    double most = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double share = std::abs(direction[axis]);
        if (share > kMovesAxis)
            most = std::min(most, limits[axis] / share);
    }
    return most;
}

/// Unit vector at the start or at the end of an arc, including its growing radius and its pitch.
Vec3 arcDirection(const Motion& motion, bool atEnd) {
    const PlaneAxes plane = axes(motion.plane);
    const Vec2 centre = inPlane(motion.centre, plane);
    const Vec2 first = inPlane(motion.start, plane) - centre;
    const Vec2 last = inPlane(motion.end, plane) - centre;
    const Vec2 spoke = atEnd ? last : first;
    const double radius = glm::length(spoke);
    const double growth = glm::length(last) - glm::length(first);
    const Vec2 outward = radius > 0 ? spoke / radius : Vec2(1, 0);
    const Vec2 inPlaneDirection = outward * growth + Vec2(-spoke.y, spoke.x) * motion.sweep;
    Vec3 direction(0);
    direction[plane.first] = inPlaneDirection.x;
    direction[plane.second] = inPlaneDirection.y;
    direction[plane.normal] = motion.end[plane.normal] - motion.start[plane.normal];
    const double length = glm::length(direction);
    return length > 0 ? direction / length : Vec3(1, 0, 0);
}

/// Goes through a program and assigns the times to its blocks.
class TimeKeeping {
public:
    TimeKeeping(std::shared_ptr<const Program> program, const Machine& machine)
        : m_machine(machine), m_limits{Vec3(machine.rapidXY, machine.rapidXY, machine.rapidZ) /
                                           kSecondsPerMinute,
                                       Vec3(machine.accelerationXY, machine.accelerationXY,
                                            machine.accelerationZ)},
          m_program(*program), m_times(std::make_shared<MachineTimes>()),
          m_plan(machine.cornerDeviation,
                 [this](std::uint32_t block, double seconds) { put(block, seconds); }) {
        m_times->secondsAfter.assign(program->blockCount() + 1, 0);
        m_times->lengthAfter.assign(program->blockCount() + 1, 0);
        m_times->program = std::move(program);
    }

    std::shared_ptr<const MachineTimes> run(const WorkContext& context) {
        for (m_block = 0; m_block < m_program.blockCount(); ++m_block) {
            if (m_block % kMotionsBetweenLooks == 0 && context.stopped())
                return nullptr;
            const auto motions = m_program.blockMotions(m_block);
            for (std::size_t index = motions.first; index < motions.last; ++index) {
                passEvents(index);
                move(m_program.motion(index));
            }
        }
        m_block = std::max<std::size_t>(m_block, 1) - 1; // events after the last block belong to it
        passEvents(m_program.motionCount());
        m_plan.stop();
        for (auto* sums : {&m_times->secondsAfter, &m_times->lengthAfter}) {
            for (std::size_t block = 1; block < sums->size(); ++block)
                (*sums)[block] += (*sums)[block - 1];
        }
        return m_times;
    }

private:
    /// Processes all events before a motion.
    void passEvents(std::size_t motion) {
        for (const auto& events = m_program.events();
             m_event < events.size() && events[m_event].beforeMotion <= motion; ++m_event) {
            if (const auto* dwell = std::get_if<Dwell>(&events[m_event].data))
                addStandstill(&TimeParts::dwell, dwell->seconds);
            else if (const auto* change = std::get_if<ToolChange>(&events[m_event].data))
                changeTool(change->tool);
            else if (std::holds_alternative<ProgramStop>(events[m_event].data) ||
                     std::holds_alternative<ProgramEnd>(events[m_event].data))
                m_plan.stop();
        }
    }

    void changeTool(int tool) {
        if (std::exchange(m_spindle, tool) == tool)
            return;
        m_plan.stop();
        ofTool(tool);
        addStandstill(&TimeParts::toolChange, m_machine.toolChangeSeconds);
    }

    void addStandstill(double TimeParts::*part, double seconds) {
        m_plan.stop();
        m_times->parts.*part += seconds;
        if (!m_times->tools.empty())
            m_times->tools[m_tool].parts.*part += seconds;
        if (m_block + 1 >= m_times->secondsAfter.size())
            return;
        m_times->secondsAfter[m_block + 1] += seconds;
        if (seconds > 0)
            m_times->standstills.push_back({m_block, seconds});
    }

    /// Motions that are planned together are either all rapids or none, and of one tool.
    void put(std::uint32_t block, double seconds) {
        double TimeParts::*part = m_rapid ? &TimeParts::rapid : &TimeParts::feed;
        m_times->parts.*part += seconds;
        m_times->tools[m_tool].parts.*part += seconds;
        m_times->secondsAfter[std::size_t{block} + 1] += seconds;
    }

    MachineTimes::OfTool& ofTool(int tool) {
        auto& tools = m_times->tools;
        const auto found = std::ranges::find(tools, tool, &MachineTimes::OfTool::tool);
        m_tool = static_cast<std::size_t>(found - tools.begin());
        if (found == tools.end())
            tools.push_back({tool, {}, 0});
        return tools[m_tool];
    }

    void move(const Motion& motion) {
        const bool rapid = motion.kind == MotionKind::rapid;
        if (rapid != m_rapid || m_times->tools.empty() || m_times->tools[m_tool].tool != motion.tool) {
            m_plan.stop();
            m_rapid = rapid;
            ofTool(motion.tool);
        }
        m_times->motionsFromUnknown += motion.known() ? 0 : 1;
        const std::optional<PathPiece> piece =
            motion.kind == MotionKind::arc ? arcPiece(motion) : straightPiece(motion);
        if (!piece)
            return;
        m_plan.add(*piece);
        m_times->lengthAfter[m_block + 1] += piece->length;
        if (!rapid)
            m_times->tools[m_tool].feedLength += piece->length;
    }

    double feedOf(const Motion& motion) {
        m_times->motionsWithoutFeed += motion.feedMmPerMin > 0 ? 0 : 1;
        const double most = m_machine.largestFeed;
        return (motion.feedMmPerMin > 0 ? std::min(motion.feedMmPerMin, most) : most) / kSecondsPerMinute;
    }

    std::optional<PathPiece> straightPiece(const Motion& motion) {
        Vec3 way = motion.end - motion.start;
        for (int axis = 0; axis < 3; ++axis) {
            if ((motion.startKnown & motion.endKnown & (1 << axis)) == 0)
                way[axis] = 0;
        }
        const double length = glm::length(way);
        if (!(length > 0))
            return std::nullopt;
        const Vec3 direction = way / length;
        PathPiece piece;
        piece.length = length;
        piece.startDirection = piece.endDirection = direction;
        piece.acceleration = along(direction, m_limits.acceleration);
        piece.topSpeed = along(direction, m_limits.speed);
        if (motion.kind != MotionKind::rapid)
            piece.topSpeed = std::min(piece.topSpeed, feedOf(motion));
        piece.owner = static_cast<std::uint32_t>(m_block);
        return piece;
    }

    std::optional<PathPiece> arcPiece(const Motion& motion) {
        const double length = pathLength(motion);
        if (!(length > 0))
            return std::nullopt;
        const PlaneAxes plane = axes(motion.plane);
        Vec3 most(0); // the largest share of the length by which an axis moves anywhere on the arc
        most[plane.first] = most[plane.second] = 1;
        most[plane.normal] = std::abs(motion.end[plane.normal] - motion.start[plane.normal]) / length;
        const double endRadius = glm::length(inPlane(motion.end, plane) - inPlane(motion.centre, plane));
        const double curvature =
            (arcRadius(motion) + endRadius) / 2 * (motion.sweep / length) * (motion.sweep / length);
        const double sideways =
            std::min(m_limits.acceleration[plane.first], m_limits.acceleration[plane.second]);
        PathPiece piece;
        piece.length = length;
        piece.straight = false;
        piece.startDirection = arcDirection(motion, false);
        piece.endDirection = arcDirection(motion, true);
        piece.acceleration = along(most, m_limits.acceleration);
        piece.topSpeed = std::min(along(most, m_limits.speed), feedOf(motion));
        if (curvature > 0)
            piece.topSpeed = std::min(piece.topSpeed, std::sqrt(sideways / curvature));
        piece.owner = static_cast<std::uint32_t>(m_block);
        return piece;
    }

    const Machine& m_machine;
    const AxisLimits m_limits;
    const Program& m_program;
    std::shared_ptr<MachineTimes> m_times;
    VelocityPlan m_plan;
    std::size_t m_block = 0;
    std::size_t m_event = 0;
    std::size_t m_tool = 0; ///< index in the table of tools
    int m_spindle = 0;
    bool m_rapid = false;
};

} // namespace

double MachineTimes::movingSeconds(std::size_t block) const {
    double seconds = secondsAfter[block + 1] - secondsAfter[block];
    for (auto addStandstill = std::ranges::lower_bound(standstills, block, {}, &Standstill::block);
         addStandstill != standstills.end() && addStandstill->block == block; ++addStandstill)
        seconds -= addStandstill->seconds;
    return std::max(0.0, seconds); // differences of sums are not exact
}

std::shared_ptr<const MachineTimes> machineTimes(std::shared_ptr<const Program> program,
                                                 const Machine& machine, const WorkContext& context) {
    return TimeKeeping(std::move(program), machine).run(context);
}

} // namespace proveout
