// SPDX-License-Identifier: GPL-3.0-or-later
// The travel of the axes, in machine coordinates.
#include <array>
#include <optional>
#include <string>
#include <utility>

#include "core/cutter/gauge_length.h"
#include "core/verification/findings/rule_findings.h"
#include "core/verification/rules/rules.h"

namespace proveout {

namespace {

constexpr double kRounding = 1e-3; ///< mm; the least increment of a control

/// From where to where an axis moves, as far as it is known.
struct Stretch {
    double from;
    double to;
};

std::optional<Stretch> stretchOf(const Motion& motion, int axis) {
    const bool start = (motion.startKnown & axisBit(axis)) != 0;
    const bool end = (motion.endKnown & axisBit(axis)) != 0;
    if (start && end) {
        const Box3 box = bounds(motion);
        return Stretch{box.lo[axis], box.hi[axis]};
    }
    if (!start && !end)
        return {};
    const double known = start ? motion.start[axis] : motion.end[axis];
    return Stretch{known, known};
}

class TravelCheck {
public:
    TravelCheck(const CheckedRun& run, RuleFindings& out)
        : m_run(run), m_zero(run.machine->programZero()), m_out(out) {
        for (int axis = 0; axis < 3; ++axis)
            m_travel[static_cast<std::size_t>(axis)] = run.machine->travel(axis);
    }

    void judge() {
        if (!m_zero)
            return;
        for (std::size_t block = 0; block < m_run.program.blockCount(); ++block) {
            const auto motions = m_run.program.blockMotions(block);
            for (std::size_t index = motions.first; index < motions.last; ++index)
                judge(m_run.program.motion(index), block);
        }
    }

private:
    void judge(const Motion& motion, std::size_t block) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto& travel = m_travel[static_cast<std::size_t>(axis)];
            const std::optional<double> shift = travel ? shiftOf(motion, axis) : std::nullopt;
            const auto stretch = shift ? stretchOf(motion, axis) : std::nullopt;
            if (!stretch)
                continue;
            addBeyond(motion, block, axis, travel->first - (stretch->from + *shift), travel->first);
            addBeyond(motion, block, axis, stretch->to + *shift - travel->second, travel->second);
        }
    }

    void addBeyond(const Motion& motion, std::size_t block, int axis, double beyond, double limit) {
        if (beyond > kRounding)
            m_out.add(rule_finding::kTravelLimit, block, motion.tool, beyond, limit,
                      std::string(1, letterOfAxis(axis)));
    }

    /// From program to machine coordinates; nothing for Z of a tool without a known length.
    [[nodiscard]] std::optional<double> shiftOf(const Motion& motion, int axis) const {
        const double zero = (*m_zero)[axis];
        if (axis != 2)
            return zero;
        const auto length = gaugeLength(m_run.setup.tools.find(m_run.tools.tool(motion.tool)));
        return length ? std::optional(zero + *length) : std::nullopt;
    }

    const CheckedRun& m_run;
    std::optional<Vec3> m_zero;
    std::array<std::optional<std::pair<double, double>>, 3> m_travel;
    RuleFindings& m_out;
};

} // namespace

void judgeTravel(const CheckedRun& run, const RuleLimits&, RuleFindings& out) {
    if (run.machine != nullptr)
        TravelCheck(run, out).judge();
}

} // namespace proveout
