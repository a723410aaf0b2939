// SPDX-License-Identifier: GPL-3.0-or-later
// The clearance of shanks and holders from the stock of their moment.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <map>
#include <utility>

#include "core/cutting/cut/assembly_contact.h"
#include "core/cutting/cut/cutting.h"
#include "core/verification/findings/rule_findings.h"
#include "core/verification/rules/rules.h"
#include "core/verification/rules/stock_of_moment.h"

namespace proveout {

namespace {

constexpr double kFine = 1e-3; ///< mm, of a distance

/// How much nearer than the clearance a part passes, and where the stock is there.
struct Nearness {
    double missing = 0;
    Vec3 place{0};
};

/// One part of all tools.
class PartClearance {
public:
    PartClearance(const CheckedRun& run, PartContact AssemblyContact::*part, double clearance)
        : m_run(run), m_part(part), m_clearance(clearance),
          m_grid(std::hypot(run.end.grid().hx, run.end.grid().hy)), m_stock(run) {}

    void judge(const FindingRow& row, RuleFindings& out) {
        for (std::size_t block = 0; block < m_run.program.blockCount(); ++block)
            if (const Nearness worst = worstOf(block); worst.missing > 0)
                out.add(row, block, m_run.toolOf(block), worst.missing, m_clearance,
                        fmt::format("{:.3g}", m_grid), worst.place);
    }

private:
    /// A tool as wide as it counts: the true edge of the stock is up to the diagonal of a cell beside the
    /// points of the grid that show it.
    [[nodiscard]] ToolAssembly wider(const Cutter& cutter, double clearance) const {
        return ToolAssembly(cutter, clearance, m_grid);
    }
    const ToolAssembly& widest(const Cutter& cutter) {
        const auto known = m_widest.find(&cutter);
        return known != m_widest.end() ? known->second
                                       : m_widest.emplace(&cutter, wider(cutter, m_clearance)).first->second;
    }

    Nearness worstOf(std::size_t block) {
        const auto motions = m_run.program.blockMotions(block);
        Nearness worst;
        if (!mayTouch(motions.first, motions.last))
            return worst;
        ZMap map(m_stock.before(block).snapshot());
        for (std::size_t index = motions.first; index < motions.last; ++index) {
            const Motion motion = m_run.program.motion(index);
            const Cutter* cutter = cutterOf(motion);
            if (cutter == nullptr)
                continue;
            const Nearness here = nearness(map, *cutter, motion);
            if (here.missing > worst.missing)
                worst = here;
            if (index + 1 < motions.last)
                (void)cut(map, *cutter, motion);
        }
        return worst;
    }

    bool mayTouch(std::size_t first, std::size_t last) {
        for (std::size_t index = first; index < last; ++index) {
            const Motion motion = m_run.program.motion(index);
            const Cutter* cutter = cutterOf(motion);
            if (cutter != nullptr && motion.known() && !widest(*cutter).staysAbove(m_run.setup.stock, motion))
                return true;
        }
        return false;
    }

    [[nodiscard]] const Cutter* cutterOf(const Motion& motion) const {
        return motion.probing ? nullptr : m_run.setup.tools.find(m_run.tools.tool(motion.tool));
    }

    /// 0 if it is as far as it should be, or collides, which is a fault of its own.
    Nearness nearness(const ZMap& map, const Cutter& cutter, const Motion& motion) {
        const auto touch = [&](const ToolAssembly& tool) { return (*tool.contact(map, motion, {})).*m_part; };
        PartContact contact = touch(widest(cutter));
        if (contact.depth == 0 || touch(ToolAssembly(cutter)).depth > 0)
            return {};
        double free = 0;
        double touching = m_clearance;
        while (touching - free > kFine) {
            const double middle = (free + touching) / 2;
            const PartContact nearer = touch(wider(cutter, middle));
            (nearer.depth > 0 ? touching : free) = middle;
            if (nearer.depth > 0)
                contact = nearer;
        }
        return {m_clearance - free, contact.place};
    }

    const CheckedRun& m_run;
    PartContact AssemblyContact::*m_part;
    double m_clearance;
    double m_grid; ///< what it cannot show of the sides of the stock, mm
    StockOfMoment m_stock;
    std::map<const Cutter*, ToolAssembly> m_widest;
};

void judgePart(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out, const FindingRow& row,
               PartContact AssemblyContact::*part) {
    if (limits.holderClearance > 0 && run.begin != nullptr)
        PartClearance(run, part, limits.holderClearance).judge(row, out);
}

} // namespace

void judgeHolderClearance(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out) {
    judgePart(run, limits, out, rule_finding::kHolderNear, &AssemblyContact::holder);
}

void judgeShankClearance(const CheckedRun& run, const RuleLimits& limits, RuleFindings& out) {
    judgePart(run, limits, out, rule_finding::kShankNear, &AssemblyContact::shank);
}

} // namespace proveout
