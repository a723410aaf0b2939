// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verification/check/check.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "core/base/figures_argument.h"
#include "core/base/memory.h"
#include "core/cutting/fixtures/fixture_heights.h"
#include "core/cutting/fixtures/fixture_surface.h"
#include "core/decimation/regions/region_decimator.h"
#include "core/part/part_findings.h"
#include "core/simulation/run/cutting_findings.h"
#include "core/simulation/run/simulation.h"
#include "core/simulation/run/walled_moment.h"
#include "core/simulation/setup/setup_memory.h"
#include "core/simulation/time/machine_time.h"
#include "core/verification/check/cutter_of.h"
#include "core/verification/findings/check_findings.h"
#include "core/verification/findings/findings.h"
#include "core/verification/findings/rule_findings.h"
#include "core/verification/part/comparison_findings.h"
#include "core/verification/rules/rules.h"
#include "core/verification/rules/tool_comments.h"
#include "core/verification/verdict/not_checked.h"

namespace proveout {

/// The program on its stock, which the next version may continue from.
struct CheckedStock {
    std::shared_ptr<const Setup> setup;
    std::unique_ptr<Simulation> simulation;
    std::optional<ZMapSnapshot> begin; ///< the uncut stock, if a rule needs it
};

namespace {

/// Progress before and after the cutting, which takes nearly all of the time.
constexpr double kTimed = 0.05;
constexpr double kCut = 0.9;
constexpr double kRecorded = 0.95;
constexpr double kJudged = 0.97;
/// What a checker keeps is at most one of so many parts of the memory.
constexpr double kKeptShare = 4;

DecimationParameters withoutDecimation(const Setup& setup) {
    DecimationParameters parameters;
    parameters.method = DecimationMethod::none;
    parameters.period = 0;
    parameters.regionCells = defaultRegion(parameters.method, gridPoints(setup.stock, setup.spacing));
    return parameters;
}

/// The check of one program.
class Check {
public:
    Check(const CheckSubject& subject, const CheckRules& rules, const WorkContext& context,
          std::size_t checkpointBytes)
        : m_subject(subject), m_program(*subject.program), m_rules(rules), m_context(context),
          m_checkpointBytes(checkpointBytes) {}

    /// Continues from the stock of an earlier version, if it is the same stock with the same tools.
    void continueFrom(std::unique_ptr<CheckedStock> stock) {
        const bool same = stock && *stock->setup == *m_subject.setup && (stock->begin || !needsBegin());
        if (same)
            m_stock = std::move(stock);
    }
    /// The stock, whose simulation is at a valid block even if the check was stopped; null without one.
    [[nodiscard]] std::unique_ptr<CheckedStock> takeStock() { return std::move(m_stock); }
    [[nodiscard]] std::size_t blocksCut() const { return m_blocksCut; }

    Result<std::shared_ptr<const CheckReport>> run() {
        add(m_subject.warnings);
        add(m_program.diagnostics());
        m_report.ofText = m_report.findings.size();
        add(findingsOf(m_subject.setup->fixtures));
        addUnknownIds();
        if (!m_rules.isOff(rule_finding::kCommentShape.id))
            add(differingComments(m_subject.proposals, m_subject.setup->tools));
        if (m_subject.hasStock) {
            if (auto done = simulate(); !done)
                return tl::unexpected(std::move(done.error()));
        } else {
            m_tools = ToolChoice(m_program, *m_subject.setup);
            if (m_subject.part)
                add(Diagnostics{diagnosticOf(part_finding::kNoStock)});
        }
        if (m_context.stopped())
            return nullptr;
        m_report.notChecked = notChecked(
            {m_program, *m_subject.setup, m_tools, m_subject.hasStock, machine(), m_subject.stockFitted},
            m_rules.accepted);
        const auto saysSo = [](const CheckFinding& one) { return one.diagnostic.unverified; };
        const bool unsaid = m_program.unverified() && std::ranges::none_of(m_report.findings, saysSo);
        m_report.programUnverified = unsaid || m_program.motionCount() == 0;
        m_context.report(1);
        return std::make_shared<const CheckReport>(m_report.answered(m_rules.accepted, m_rules.waivers));
    }

private:
    void add(const Diagnostics& diagnostics) {
        for (const Diagnostic& diagnostic : diagnostics)
            add(CheckFinding{.diagnostic = diagnostic});
    }
    void add(CheckFinding finding) {
        if (finding.lastLine == 0)
            finding.lastLine = finding.diagnostic.where.line;
        if (const Cutter* cutter = m_subject.setup->tools.find(finding.tool); cutter && finding.block > 0)
            finding.cutter = cutterOf(cutter->spec(), finding.diagnostic.id);
        m_report.findings.push_back(std::move(finding));
    }

    /// A misspelt id must not pass quietly.
    void addUnknownIds() {
        const auto isOpen = [](const std::string& id) {
            return std::ranges::any_of(notCheckedRows(),
                                       [&](const NotCheckedRow& row) { return id == row.id; });
        };
        const auto addUnknown = [this](const std::string& id) {
            if (findFinding(std::string(ruleOf(id))) == nullptr)
                add(Diagnostics{diagnosticOf(check_finding::kRuleSettingUnknown, {id})});
        };
        for (const auto& [id, reason] : m_rules.off)
            addUnknown(id);
        for (const auto& [name, value] : m_rules.limitsOfTools)
            if (const auto limit = parseLimitOfTool(name); !limit || !isJudgedBy(*limit))
                add(Diagnostics{diagnosticOf(check_finding::kRuleSettingUnknown, {name})});
        for (const auto& [id, reason] : m_rules.accepted)
            if (!isOpen(id))
                add(Diagnostics{diagnosticOf(check_finding::kRuleSettingUnknown, {id})});
    }

    /// Keeping the uncut stock keeps the tiles that will be cut: only where a rule needs them.
    [[nodiscard]] bool needsBegin() const {
        return m_subject.keepsResult || m_rules.any([](const RuleLimits& limits) {
            return limits.rapidClearance > 0 || limits.holderClearance > 0;
        });
    }

    Result<void> prepareStock() {
        if (m_stock) {
            (void)m_stock->simulation->noteProgram(m_subject.program);
            return {};
        }
        auto made = Simulation::create(m_subject.program, m_subject.setup,
                                       withoutDecimation(*m_subject.setup), m_context.quiet());
        if (!made)
            return tl::unexpected(std::move(made.error()));
        m_stock = std::make_unique<CheckedStock>();
        m_stock->setup = m_subject.setup;
        m_stock->simulation = std::move(*made);
        m_stock->simulation->setCheckpointBudget(m_checkpointBytes);
        if (needsBegin())
            m_stock->begin = m_stock->simulation->zmap();
        return {};
    }

    Result<void> simulate() {
        if (auto prepared = prepareStock(); !prepared)
            return prepared;
        Simulation& simulation = *m_stock->simulation;
        m_tools = simulation.tools();
        const auto times =
            machineTimes(m_subject.program, m_subject.machine.value_or(Machine()), m_context.part(0, kTimed));
        if (!times)
            return {};
        const std::size_t cutBefore = simulation.effort().blocksCut;
        simulation.keepRecordsOf(
            neededRecords(runOf(simulation, *times, simulation.zmap(), 0), m_rules, m_context));
        simulation.seek(m_program.blockCount(), m_context.part(kTimed, kCut));
        if (!m_context.stopped())
            judgeRun(simulation, times);
        m_blocksCut = simulation.effort().blocksCut - cutBefore;
        return {};
    }

    [[nodiscard]] CheckedRun runOf(const Simulation& simulation, const MachineTimes& times,
                                   const ZMapSnapshot& end, double removedMm3) const {
        return {.program = m_program,
                .setup = *m_subject.setup,
                .tools = m_tools,
                .machine = machine(),
                .times = times,
                .rows = simulation.rows(),
                .begin = m_stock->begin && needsBegin() ? &*m_stock->begin : nullptr,
                .end = end,
                .removedMm3 = removedMm3};
    }

    void judgeRun(Simulation& simulation, const std::shared_ptr<const MachineTimes>& times) {
        Frame frame = simulation.frame();
        addAboutSetup(frame.findings);
        addOfBlocks(simulation.findings());
        const CheckedRun run = runOf(simulation, *times, frame.zmap, frame.removedMm3);
        for (BlockSet missing = neededRecords(run, m_rules, m_context); !missing.empty();
             missing = neededRecords(run, m_rules, m_context)) {
            if (!simulation.record(missing, m_context.part(kCut, kRecorded)))
                return;
        }
        for (const RuleFinding& finding : judge(run, m_rules, m_context.part(kRecorded, kJudged)))
            addOfRule(finding, unitOf(*finding.row));
        for (const FirstContact& contact : firstContacts(run))
            m_report.firstContacts.push_back({contact, lineOf(contact.block)});
        if (m_subject.keepsResult)
            keep(frame, times);
        if (m_subject.part)
            compare(frame, *m_subject.part);
    }

    [[nodiscard]] std::string specOf(int tool) const {
        const Cutter* cutter = m_subject.setup->tools.find(tool);
        return cutter == nullptr ? std::string() : cutter->spec();
    }

    /// Gives the frame its walls.
    void keep(Frame& frame, const std::shared_ptr<const MachineTimes>& times) {
        const bool isShaped = m_subject.setup->shape.kind != StockKind::box;
        addWalls(frame, isShaped ? &*m_stock->begin : nullptr);
        auto result = std::make_shared<CheckedResult>();
        result->stock = frame.zmap;
        result->removedMm3 = frame.removedMm3;
        result->times = times;
        result->machineAssumed = machine() == nullptr;
        for (std::size_t k = 0; k < m_program.motionCount(); ++k) {
            const Motion& motion = m_program.motion(k);
            if (motion.kind == MotionKind::rapid)
                continue;
            const int tool = m_tools.tool(motion.tool);
            auto at = std::ranges::find(result->tools, tool, &CheckedResult::OfTool::tool);
            if (at == result->tools.end())
                at = result->tools.insert(at, {tool, specOf(tool), motion.end.z});
            at->lowestZ = std::min({at->lowestZ, motion.start.z, motion.end.z});
        }
        m_report.result = std::move(result);
    }

    void compare(const Frame& end, const PartToCompare& with) {
        add(with.of.findings);
        if (with.of.part == nullptr)
            return;
        const StockBox& stock = m_subject.setup->stock;
        add(placementFindings(*with.of.part, stock, with.tolerance));
        if (isMisplaced(*with.of.part, stock))
            return;
        m_report.part = comparePart(end, with.of.part, with.tolerance, m_context.part(kJudged, 1));
        if (m_report.part == nullptr)
            return;
        for (const RuleFinding& finding : findingsOf(*m_report.part))
            if (!m_rules.isOff(finding.row->id, finding.tool))
                addOfRule(finding, comparisonUnit(*finding.row));
    }

    [[nodiscard]] const Machine* machine() const { return m_subject.machine ? &*m_subject.machine : nullptr; }

    /// What is known before any block; findings of blocks are added with more about them.
    void addAboutSetup(const Diagnostics& diagnostics) {
        for (const Diagnostic& diagnostic : diagnostics) {
            const auto isIt = [&](const FindingRow* row) { return hasIdOf(diagnostic, *row); };
            if (std::ranges::none_of(cutting_finding::kCuttingRows, isIt))
                add(CheckFinding{.diagnostic = diagnostic});
        }
    }

    void addOfBlocks(const FindingLog& log) {
        for (FindingGroup& group : log.groups(m_program, m_tools)) {
            if (m_rules.isOff(group.worst.id, group.tool))
                continue;
            add(CheckFinding{.diagnostic = std::move(group.worst),
                             .block = group.firstBlock + 1,
                             .worstBlock = group.worstBlock + 1,
                             .count = group.count,
                             .lastLine = lineOf(group.lastBlock),
                             .tool = group.tool,
                             .value = group.value,
                             .unit = group.unit,
                             .place = group.place.value_or(endOf(group.worstBlock))});
        }
    }

    void addOfRule(const RuleFinding& finding, const char* unit) {
        CheckFinding out{.diagnostic = diagnosticOf(finding, m_program),
                         .count = finding.count,
                         .tool = finding.tool,
                         .value = finding.value,
                         .limit = finding.limit,
                         .unit = unit,
                         .place = finding.place};
        if (finding.block) {
            out.block = *finding.block + 1;
            out.worstBlock = finding.worstBlock + 1;
            out.lastLine =
                finding.lastLine > 0 ? static_cast<int>(finding.lastLine) : lineOf(finding.lastBlock);
            out.place = finding.place.value_or(endOf(finding.worstBlock));
        }
        add(std::move(out));
    }

    [[nodiscard]] int lineOf(std::size_t block) const { return static_cast<int>(m_program.blockLine(block)); }
    [[nodiscard]] Vec3 endOf(std::size_t block) const {
        return m_program.endOf(m_program.blockMotions(block).last - 1);
    }

    const CheckSubject& m_subject;
    const Program& m_program;
    const CheckRules& m_rules;
    const WorkContext& m_context;
    std::size_t m_checkpointBytes;
    std::size_t m_blocksCut = 0;
    ToolChoice m_tools;
    std::unique_ptr<CheckedStock> m_stock;
    CheckReport m_report;
};

} // namespace

namespace {

/// Of the heights of the fixtures, which are kept from one check to the next.
double fixtureBytes(const Fixtures& fixtures) {
    double bytes = 0;
    for (const auto& named : fixtures)
        if (const auto* mesh = std::get_if<FixtureMesh>(&named.second); mesh != nullptr && isUsable(*mesh))
            bytes += FixtureHeights::mostBytes(mesh->surface->facets().size());
    return bytes;
}

} // namespace

Result<double> checkBytes(const CheckSubject& subject) {
    if (!subject.hasStock)
        return 0;
    const auto grid = makeGrid(subject.setup->stock, subject.setup->spacing);
    if (!grid)
        return tl::unexpected(grid.error());
    constexpr double kOfBlock = sizeof(BlockStatistics) + MachineTimes::kBytesPerBlock;
    return memoryForecast(*subject.setup, *grid, withoutDecimation(*subject.setup)).most +
           zmapBytes(*grid) + // Simulation::record()
           fixtureBytes(subject.setup->fixtures) + (subject.part ? comparisonBytes(*grid) : 0) +
           kOfBlock * static_cast<double>(subject.program->blockCount());
}

Checker::Checker(std::size_t checkpointBytes) : m_checkpointBytes(checkpointBytes) {}
Checker::~Checker() = default;

Result<std::shared_ptr<const CheckReport>> Checker::check(const CheckSubject& subject,
                                                          const CheckRules& rules, std::uint64_t memoryBytes,
                                                          const WorkContext& context) {
    std::unique_ptr<CheckedStock> kept = std::move(m_kept); // given up if this check fails
    const auto needed = checkBytes(subject);
    if (!needed)
        return tl::unexpected(needed.error());
    if (*needed > static_cast<double>(memoryBytes))
        return failure(check_finding::kCheckNeedsMemory,
                       {figures("{}", readableBytes(*needed)),
                        figures("{}", readableBytes(static_cast<double>(memoryBytes)))});
    const double wouldKeep = *needed + static_cast<double>(m_checkpointBytes);
    const bool keeps = m_checkpointBytes > 0 && kKeptShare * wouldKeep <= static_cast<double>(memoryBytes);
    Check check(subject, rules, context, keeps ? m_checkpointBytes : 0);
    if (keeps)
        check.continueFrom(std::move(kept));
    kept.reset();
    auto result = check.run();
    m_blocksCut = check.blocksCut();
    if (keeps && result)
        m_kept = check.takeStock();
    return result;
}

Result<std::shared_ptr<const CheckReport>> check(const CheckSubject& subject, const CheckRules& rules,
                                                 std::uint64_t memoryBytes, const WorkContext& context) {
    return Checker().check(subject, rules, memoryBytes, context);
}

} // namespace proveout
