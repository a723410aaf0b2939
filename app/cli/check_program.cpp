// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/check_program.h"

#include <algorithm>
#include <exception>
#include <memory>
#include <new>
#include <utility>

#include "app/cli/check_inputs.h"
#include "app/cli/check_steps.h"
#include "app/cli/digest.h"
#include "app/cli/part_json.h"
#include "core/base/memory.h"
#include "core/base/stop_watch.h"
#include "core/formats/job_paths.h"
#include "core/verification/findings/command_line_findings.h"
#include "core/verification/findings/findings.h"

namespace proveout::cli {

namespace {

/// Reads one program with its job, and checks it.
class ProgramCheck {
public:
    ProgramCheck(CheckedProgram& checked, const CheckOptions& options)
        : m_checked(checked), m_options(options) {}

    void run() {
        auto job = m_options.setup.jobOf(m_checked.input.string(), isJob(m_checked.input));
        if (!job)
            return refuse(std::move(job.error()));
        m_job = std::move(*job);
        if (auto fits = m_options.settings.apply(m_job.check); !fits)
            return refuse(std::move(fits.error()));
        if (auto fits = m_options.part.apply(m_job.part); !fits)
            return refuse(std::move(fits.error()));
        m_checked.program = m_job.program;
        m_checked.files = filesOf(m_job);
        if (auto read = interpret(); !read)
            return refuse(m_job.warnings, read.error());
        const bool hasStock = isJob(m_checked.input) || m_options.setup.stockGiven();
        const auto report = judgeJob(
            m_job, m_read,
            {.hasStock = hasStock, .keepsResult = m_options.keepsResult, .memoryBytes = memoryLimitBytes()},
            m_options.setup);
        if (!report)
            return refuseRead(report.error());
        m_checked.report = **report;
        nameFiles();
    }

private:
    /// The input cannot be used for these reasons, which follow what was found before.
    void refuse(Diagnostics found, const Diagnostics& reasons = {}) {
        m_checked.unusable = true;
        found.insert(found.end(), reasons.begin(), reasons.end());
        for (Diagnostic& diagnostic : found) {
            const int line = diagnostic.where.line;
            m_checked.report.findings.push_back({.diagnostic = std::move(diagnostic), .lastLine = line});
        }
        nameFiles();
    }

    /// The same after the program was read.
    void refuseRead(const Diagnostics& reasons) {
        Diagnostics found = m_job.warnings;
        found.insert(found.end(), m_read.program->diagnostics().begin(), m_read.program->diagnostics().end());
        refuse(std::move(found), reasons);
    }

    void nameFiles() {
        for (CheckFinding& finding : m_checked.report.findings)
            if (finding.diagnostic.file.empty())
                finding.diagnostic.file =
                    m_checked.program.empty() ? m_checked.input.string() : m_checked.program.string();
    }

    Result<void> interpret() {
        const auto text = NcText::load(m_job.program);
        if (!text)
            return tl::unexpected(text.error());
        const auto read = [&](const InterpretOptions& options) {
            return proveout::interpret(*text, options);
        };
        m_read = interpretJob(m_job, *text, read, read);
        if (m_read.program->foreignKind() != nullptr)
            return tl::unexpected(m_read.program->diagnostics());
        return {};
    }

    CheckedProgram& m_checked;
    const CheckOptions& m_options;
    Job m_job;
    InterpretedJob m_read;
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
    if (!finding.cutter.empty())
        out["cutter"] = finding.cutter;
    if (*finding.unit != '\0')
        out.update({{"value", finding.value}, {"limit", finding.limit}, {"unit", finding.unit}});
    if (finding.place)
        out.update({{"x", finding.place->x}, {"y", finding.place->y}, {"z", finding.place->z}});
    if (!diagnostic.arguments.empty())
        out["values"] = valuesOf(diagnostic);
    if (*diagnostic.hint != '\0')
        out["hint"] = hintText(diagnostic);
    if (finding.waived)
        out["waived"] = {{"reason", finding.waived->reason}, {"owner", finding.waived->owner}};
    return out;
}

void addInput(nlohmann::ordered_json& inputs, const std::filesystem::path& file) {
    const auto digest = file.empty() ? std::nullopt : sha256(file);
    if (digest)
        inputs.push_back({{"file", file.string()}, {"sha256", *digest}});
}

nlohmann::ordered_json toJson(const TimeParts& parts, bool assumed) {
    return {{"total", parts.total()}, {"rapid", parts.rapid},           {"feed", parts.feed},
            {"dwell", parts.dwell},   {"toolChange", parts.toolChange}, {"assumed", assumed}};
}

nlohmann::ordered_json toJson(const CheckedResult& result) {
    const StockBox& stock = result.stock.stock();
    const Grid& grid = result.stock.grid();
    auto tools = nlohmann::ordered_json::array();
    for (const CheckedResult::OfTool& tool : result.tools) {
        nlohmann::ordered_json row{{"tool", tool.tool}, {"cutter", tool.cutter}};
        const auto at = std::ranges::find(result.times->tools, tool.tool, &MachineTimes::OfTool::tool);
        const MachineTimes::OfTool times = at == result.times->tools.end() ? MachineTimes::OfTool() : *at;
        row.update({{"feed", times.parts.feed},
                    {"rapid", times.parts.rapid},
                    {"feedLengthMm", times.feedLength},
                    {"lowestZ", tool.lowestZ}});
        tools.push_back(std::move(row));
    }
    return {{"stock",
             {{"width", stock.width},
              {"depth", stock.depth},
              {"height", stock.height},
              {"minX", stock.corner.x},
              {"minY", stock.corner.y},
              {"topZ", stock.corner.z}}},
            {"grid", {{"nx", grid.nx}, {"ny", grid.ny}, {"hx", grid.hx}, {"hy", grid.hy}}},
            {"removedMm3", result.removedMm3},
            {"machineSeconds", toJson(result.times->parts, result.machineAssumed)},
            {"tools", std::move(tools)}};
}

} // namespace

ExitCode CheckedProgram::exitCode() const {
    if (unusable)
        return ExitCode::unusable;
    switch (report.verdict()) {
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
        checked.report.findings.push_back(std::move(finding));
    };
    try {
        ProgramCheck(checked, options).run();
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
    for (const CheckFinding& finding : checked.report.findings)
        findings.push_back(toJson(finding));
    auto notChecked = nlohmann::ordered_json::array();
    for (const NotChecked& entry : checked.report.notChecked) {
        notChecked.push_back(
            {{"id", entry.row->id}, {"title", entry.row->title}, {"accepted", entry.accepted}});
        if (!entry.reason.empty())
            notChecked.back()["reason"] = entry.reason;
    }
    auto firstContacts = nlohmann::ordered_json::array();
    for (const auto& [of, line] : checked.report.firstContacts)
        firstContacts.push_back({{"tool", of.tool},
                                 {"block", of.block + 1},
                                 {"line", line},
                                 {"x", of.start.x},
                                 {"y", of.start.y},
                                 {"z", of.start.z}});
    auto inputs = nlohmann::ordered_json::array();
    addInput(inputs, checked.input);
    for (const std::filesystem::path& file : checked.files)
        if (file != checked.input)
            addInput(inputs, file);
    nlohmann::ordered_json out{
        {"program", checked.program.empty() ? checked.input.string() : checked.program.string()},
        {"verdict", name(checked.report.verdict())},
        {"exitCode", static_cast<int>(checked.exitCode())},
        {"findings", std::move(findings)},
        {"notChecked", std::move(notChecked)},
        {"firstContacts", std::move(firstContacts)},
        {"seconds", checked.seconds},
        {"inputs", std::move(inputs)}};
    if (checked.report.result)
        out["run"] = toJson(*checked.report.result);
    if (checked.report.part)
        out["part"] = toJson(*checked.report.part);
    return out;
}

} // namespace proveout::cli
