// SPDX-License-Identifier: GPL-3.0-or-later
// Rules about what holds the stock.
#include <algorithm>
#include <map>

#include "core/cutting/fixtures/fixture_contact.h"
#include "core/verification/findings/rule_findings.h"
#include "core/verification/rules/rules.h"

namespace proveout {

namespace {

/// The motions of a program beside its fixtures.
class FixtureCheck {
public:
    explicit FixtureCheck(const CheckedRun& run) : m_run(run) {}

    /// Calls `measure(tool, motion, fixture)` for each motion of each block that is known, and reports the
    /// deepest result of a block and a fixture, if it is above 0; its place is that of the tip.
    template<class Measure>
    void judge(const FindingRow& row, double limit, RuleFindings& out, const Measure& measure) {
        for (std::size_t block = 0; block < m_run.program.blockCount(); ++block) {
            for (const auto& [name, fixture] : m_run.setup.fixtures) {
                const FixtureContact worst = worstOf(block, fixture, measure);
                if (worst.depth > 0)
                    out.add(row, block, m_run.toolOf(block), worst.depth, limit, name, worst.tip);
            }
        }
    }

private:
    template<class Measure>
    FixtureContact worstOf(std::size_t block, const Fixture& fixture, const Measure& measure) {
        const auto motions = m_run.program.blockMotions(block);
        FixtureContact worst;
        for (std::size_t index = motions.first; index < motions.last; ++index) {
            Motion motion = m_run.program.motion(index);
            const ToolOutline* tool = outlineOf(motion);
            if (tool == nullptr || motion.endKnown != kAllAxes)
                continue;
            if (!motion.known()) { // only its end is
                motion.kind = MotionKind::rapid;
                motion.start = motion.end;
            }
            const FixtureContact contact = measure(*tool, motion, fixture);
            if (contact.depth > worst.depth)
                worst = contact;
        }
        return worst;
    }

    /// The outline of the tool of a motion; null if there is none.
    const ToolOutline* outlineOf(const Motion& motion) {
        const int number = m_run.tools.tool(motion.tool);
        const auto known = m_outlines.find(number);
        if (known != m_outlines.end())
            return &known->second;
        const Cutter* cutter = m_run.setup.tools.find(number);
        return cutter == nullptr ? nullptr : &m_outlines.emplace(number, *cutter).first->second;
    }

    const CheckedRun& m_run;
    std::map<int, ToolOutline> m_outlines;
};

FixtureContact collision(const ToolOutline& tool, const Motion& motion, const Fixture& fixture) {
    return fixtureContact(tool, motion, fixture).value_or(FixtureContact());
}

/// By how much the tool is nearer than `clearance`, and where its tip is then; 0 if it is not, or collides.
FixtureContact missingClearance(const ToolOutline& tool, const Motion& motion, const Fixture& fixture,
                                double clearance) {
    constexpr double kFine = 1e-3; // mm
    const auto near = fixtureContact(tool, motion, fixture, clearance);
    if (!near || fixtureContact(tool, motion, fixture))
        return {};
    double free = 0;
    double touching = clearance;
    Vec3 tip = near->tip;
    while (touching - free > kFine) {
        const double middle = (free + touching) / 2;
        const auto contact = fixtureContact(tool, motion, fixture, middle);
        (contact ? touching : free) = middle;
        if (contact)
            tip = contact->tip;
    }
    return {clearance - free, tip};
}

} // namespace

void judgeFixtures(const CheckedRun& run, const RuleLimits&, RuleFindings& out) {
    FixtureCheck(run).judge(rule_finding::kFixtureCollision, 0, out, collision);
}

void judgeFixtureClearance(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out) {
    const double clearance = limits.fixtureClearance;
    FixtureCheck(run).judge(rule_finding::kFixtureNear, clearance, out,
                            [&](const ToolOutline& tool, const Motion& motion, const Fixture& fixture) {
                                return missingClearance(tool, motion, fixture, clearance);
                            });
}

} // namespace proveout
