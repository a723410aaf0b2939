// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/check_program.h"

#include <algorithm>
#include <exception>
#include <memory>
#include <new>
#include <utility>

#include "app/cli/check_inputs.h"
#include "app/cli/digest.h"
#include "core/base/stop_watch.h"
#include "core/simulation/run/cutting_findings.h"
#include "core/simulation/run/interpretation.h"
#include "core/simulation/run/simulation.h"
#include "core/simulation/setup/tool_proposals.h"
#include "core/simulation/time/machine_time.h"
#include "core/verification/findings/command_line_findings.h"
#include "core/verification/findings/findings.h"

namespace proveout::cli {

namespace {

/// The check of one program.
class Check {
public:
    Check(CheckedProgram& checked, const CheckOptions& options) : m_checked(checked), m_options(options) {}

    void run() {
        auto job = m_options.setup.jobOf(m_checked.input.string(), isJob(m_checked.input));
        if (!job)
            return refuse(std::move(job.error()));
        m_job = std::move(*job);
        m_checked.program = m_job.program;
        m_hasStock = isJob(m_checked.input) || m_options.setup.stockGiven();
        add(m_job.warnings);
        if (!interpret() || (m_hasStock && !simulate()))
            return;
        if (!m_hasStock)
            m_tools = ToolChoice(*m_program, m_job.setup);
        m_checked.notChecked = notChecked(
            {*m_program, m_job.setup, m_tools, m_hasStock, m_job.machine.has_value()}, m_options.accepted);
        judgeAll();
    }

private:
    void refuse(Diagnostics reasons) {
        m_checked.unusable = true;
        add(std::move(reasons));
    }

    void add(Diagnostics diagnostics) {
        for (Diagnostic& diagnostic : diagnostics)
            add(CheckFinding{.diagnostic = std::move(diagnostic)});
    }
    void add(CheckFinding finding) {
        if (finding.diagnostic.file.empty())
            finding.diagnostic.file =
                m_checked.program.empty() ? m_checked.input.string() : m_checked.program.string();
        if (finding.lastLine == 0)
            finding.lastLine = finding.diagnostic.where.line;
        m_checked.findings.push_back(std::move(finding));
    }

    bool interpret() {
        const auto text = NcText::load(m_job.program);
        if (!text) {
            refuse(text.error());
            return false;
        }
        addProposals(m_job.setup.tools, proposeTools(*text));
        m_program = interpretOn(m_job.setup, *text, interpretOptions(m_job.setup, m_job.program));
        if (m_program->foreignKind() != nullptr) {
            refuse(m_program->diagnostics());
            return false;
        }
        add(m_program->diagnostics());
        return true;
    }

    /// False if there is no memory for the stock, or it is impossible.
    bool simulate() {
        m_job.parameters.method = DecimationMethod::none;
        m_job.parameters.period = 0;
        SetupOptions::settleGrid(m_job, *m_program, {});
        if (auto fits = m_options.setup.checkGrid(m_job, {}); !fits) {
            refuse(std::move(fits.error()));
            return false;
        }
        auto simulation =
            Simulation::create(m_program, std::make_shared<const Setup>(m_job.setup), m_job.parameters);
        if (!simulation) {
            refuse(std::move(simulation.error()));
            return false;
        }
        (*simulation)->setCheckpointBudget(0);
        (*simulation)->seek(m_program->blockCount());
        const Frame frame = (*simulation)->frame();
        m_tools = (*simulation)->tools();
        addAboutSetup(frame.findings);
        addOfBlocks((*simulation)->findings());
        const auto times = machineTimes(m_program, m_job.machine.value_or(Machine()));
        const CheckedRun run{.program = *m_program,
                             .setup = m_job.setup,
                             .tools = m_tools,
                             .machine = m_job.machine ? &*m_job.machine : nullptr,
                             .times = *times,
                             .rows = (*simulation)->rows(),
                             .end = frame.zmap,
                             .removedMm3 = frame.removedMm3};
        for (const RuleFinding& finding : judge(run, m_options.limits, m_options.off))
            addOfRule(finding);
        return true;
    }

    /// What is known before any block; findings of blocks are added with more about them.
    void addAboutSetup(const Diagnostics& diagnostics) {
        for (const Diagnostic& diagnostic : diagnostics) {
            const auto isIt = [&](const FindingRow* row) { return hasIdOf(diagnostic, *row); };
            if (std::ranges::none_of(cutting_finding::kCuttingRows, isIt))
                add(CheckFinding{.diagnostic = diagnostic});
        }
    }

    void addOfBlocks(const FindingLog& log) {
        for (FindingGroup& group : log.groups(*m_program, m_tools)) {
            if (m_options.off.contains(group.worst.id))
                continue;
            add(CheckFinding{.diagnostic = std::move(group.worst),
                             .block = group.firstBlock + 1,
                             .count = group.count,
                             .lastLine = lineOf(group.lastBlock),
                             .tool = group.tool,
                             .value = group.value,
                             .unit = group.unit,
                             .place = endOf(group.worstBlock)});
        }
    }

    void addOfRule(const RuleFinding& finding) {
        CheckFinding out{.diagnostic = diagnosticOf(finding, *m_program),
                         .count = finding.count,
                         .tool = finding.tool,
                         .value = finding.value,
                         .limit = finding.limit,
                         .unit = unitOf(*finding.row),
                         .place = finding.place};
        if (finding.block) {
            out.block = *finding.block + 1;
            out.lastLine = lineOf(finding.lastBlock);
            out.place = endOf(finding.worstBlock);
        }
        add(std::move(out));
    }

    [[nodiscard]] int lineOf(std::size_t block) const {
        return static_cast<int>(m_program->blockLine(block));
    }
    [[nodiscard]] Vec3 endOf(std::size_t block) const {
        return m_program->endOf(m_program->blockMotions(block).last - 1);
    }

    void judgeAll() {
        Diagnostics diagnostics;
        for (const CheckFinding& finding : m_checked.findings)
            diagnostics.push_back(finding.diagnostic);
        m_checked.verdict = verdictOf(diagnostics, m_checked.notChecked);
        if (m_program->unverified() || m_program->motionCount() == 0)
            m_checked.verdict = m_checked.verdict == Verdict::faults ? Verdict::faults : Verdict::unverified;
    }

    CheckedProgram& m_checked;
    const CheckOptions& m_options;
    Job m_job;
    bool m_hasStock = false;
    std::shared_ptr<const Program> m_program;
    ToolChoice m_tools;
};

nlohmann::ordered_json toJson(const CheckFinding& finding) {
    const Diagnostic& diagnostic = finding.diagnostic;
    nlohmann::ordered_json out{{"id", diagnostic.id},
                               {"severity", name(diagnostic.severity)},
                               {"unverified", diagnostic.unverified},
                               {"title", findingTitle(diagnostic.id)},
                               {"message", message(diagnostic)},
                               {"file", diagnostic.file}};
    if (diagnostic.where.line > 0)
        out.update({{"line", diagnostic.where.line}, {"column", diagnostic.where.column}});
    if (finding.block > 0)
        out.update({{"block", finding.block},
                    {"count", finding.count},
                    {"lastLine", finding.lastLine},
                    {"tool", finding.tool}});
    if (*finding.unit != '\0')
        out.update({{"value", finding.value}, {"limit", finding.limit}, {"unit", finding.unit}});
    if (finding.place)
        out.update({{"x", finding.place->x}, {"y", finding.place->y}, {"z", finding.place->z}});
    if (*diagnostic.hint != '\0')
        out["hint"] = hintText(diagnostic);
    return out;
}

void addInput(nlohmann::ordered_json& inputs, const std::filesystem::path& file) {
    const auto digest = file.empty() ? std::nullopt : sha256(file);
    if (digest)
        inputs.push_back({{"file", file.string()}, {"sha256", *digest}});
}

} // namespace

ExitCode CheckedProgram::exitCode() const {
    if (unusable)
        return ExitCode::unusable;
    switch (verdict) {
    case Verdict::safe:
        return ExitCode::done;
    case Verdict::faults:
        return ExitCode::faults;
    case Verdict::unverified:
        break;
    }
    return ExitCode::unverified;
}

CheckedProgram checkProgram(const std::filesystem::path& input, const CheckOptions& options) {
    const StopWatch watch;
    CheckedProgram checked{.input = input, .program = {}};
    const auto fail = [&](const FindingRow& row, std::vector<Argument> arguments) {
        checked.unusable = true;
        CheckFinding finding{.diagnostic = diagnosticOf(row, std::move(arguments))};
        finding.diagnostic.file = input.string();
        checked.findings.push_back(std::move(finding));
    };
    try {
        Check(checked, options).run();
    } catch (const std::bad_alloc&) {
        fail(command_line_finding::kCommandOutOfMemory, {});
    } catch (const std::exception& exception) {
        fail(command_line_finding::kCommandFailed, {exception.what()});
    }
    checked.seconds = watch.seconds();
    return checked;
}

nlohmann::ordered_json toJson(const CheckedProgram& checked) {
    auto findings = nlohmann::ordered_json::array();
    for (const CheckFinding& finding : checked.findings)
        findings.push_back(toJson(finding));
    auto notChecked = nlohmann::ordered_json::array();
    for (const NotChecked& entry : checked.notChecked)
        notChecked.push_back(
            {{"id", entry.row->id}, {"title", entry.row->title}, {"accepted", entry.accepted}});
    auto inputs = nlohmann::ordered_json::array();
    addInput(inputs, checked.input);
    if (checked.program != checked.input)
        addInput(inputs, checked.program);
    return {{"program", checked.program.empty() ? checked.input.string() : checked.program.string()},
            {"verdict", name(checked.verdict)},
            {"exitCode", static_cast<int>(checked.exitCode())},
            {"findings", std::move(findings)},
            {"notChecked", std::move(notChecked)},
            {"seconds", checked.seconds},
            {"inputs", std::move(inputs)}};
}

} // namespace proveout::cli
