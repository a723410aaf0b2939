// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/lsp_analysis.h"

#include <exception>
#include <fmt/format.h>
#include <new>
#include <utility>
#include <vector>

#include "core/base/memory.h"
#include "core/base/parallel.h"
#include "core/verification/findings/command_line_findings.h"
#include "core/verification/findings/rule_findings.h"
#include "core/verification/rules/tool_comments.h"

namespace proveout::cli {

namespace {

constexpr std::chrono::milliseconds kPause{150};
constexpr int kLogMessage = 4; ///< MessageType.Log

void addAll(std::vector<CheckFinding>& findings, const Diagnostics& diagnostics) {
    for (const Diagnostic& diagnostic : diagnostics)
        findings.push_back({.diagnostic = diagnostic, .lastLine = diagnostic.where.line});
}

} // namespace

std::uint64_t LspPublisher::begin(const std::string& uri) {
    const std::scoped_lock lock(m_mutex);
    m_texts[uri] = ++m_last;
    return m_last;
}

void LspPublisher::close(const std::string& uri) {
    const std::scoped_lock lock(m_mutex);
    if (m_texts.erase(uri) > 0)
        m_output.notify("textDocument/publishDiagnostics",
                        {{"uri", uri}, {"diagnostics", nlohmann::json::array()}});
}

void LspPublisher::publish(const std::string& uri, std::uint64_t number, std::optional<std::int64_t> version,
                           nlohmann::json diagnostics) {
    nlohmann::json parameters{{"uri", uri}, {"diagnostics", std::move(diagnostics)}};
    if (version)
        parameters["version"] = *version;
    const std::scoped_lock lock(m_mutex);
    const auto text = m_texts.find(uri);
    if (text != m_texts.end() && text->second == number)
        m_output.notify("textDocument/publishDiagnostics", std::move(parameters));
}

std::shared_ptr<const KnownDialect> LspAnalysis::judge(const std::string& uri, const LspDocument& document,
                                                       std::optional<std::int64_t> version, Reason reason) {
    std::shared_ptr<Kept>& kept = m_documents[uri];
    if (!kept)
        kept = std::make_shared<Kept>(fileOfUri(uri), m_options);
    if (reason != Reason::changed)
        kept->refresh = true;
    m_checks.cancel(uri);
    Task task{{uri, document, {}, m_encoding, m_relatedInformation}, kept, m_publisher.begin(uri), version};
    m_texts.submit(
        uri, reason == Reason::changed ? kPause : std::chrono::milliseconds(0),
        [this, task](const std::stop_token& stop) { guarded(task, [&] { interpret(task, stop); }); });
    return kept->dialect;
}

void LspAnalysis::close(const std::string& uri) {
    m_texts.cancel(uri);
    m_checks.cancel(uri);
    m_documents.erase(uri);
    m_publisher.close(uri);
}

template<class Work>
void LspAnalysis::guarded(const Task& task, const Work& work) {
    const auto fail = [&](const FindingRow& row, std::vector<Argument> arguments) {
        publish(task, std::vector{CheckFinding{.diagnostic = diagnosticOf(row, std::move(arguments))}});
    };
    try {
        work();
    } catch (const std::bad_alloc&) {
        fail(command_line_finding::kCommandOutOfMemory, {});
    } catch (const std::exception& exception) {
        fail(command_line_finding::kCommandFailed, {exception.what()});
    }
}

void LspAnalysis::interpret(Task task, const std::stop_token& stop) {
    Kept& kept = *task.kept;
    if (kept.refresh.exchange(false))
        kept.job.refresh();
    auto read = kept.job.job();
    Job job = read ? *read : kept.job.fallback();
    task.subject.file = job.program.string();
    const NcText text = task.subject.document.program();
    const WorkContext context{stop, {}};
    const InterpretedJob interpreted = interpretJob(
        job, text,
        [&](const InterpretOptions& options) { return kept.interpreter.interpret(text, options, context); },
        [&](const InterpretOptions& options) {
            return kept.interpreterAssuming.interpret(text, options, context);
        });
    const std::shared_ptr<const Program>& program = interpreted.program;
    if (stop.stop_requested())
        return;
    kept.dialect->set(program->dialect());
    std::vector<CheckFinding> findings;
    if (!read)
        addAll(findings, read.error());
    addAll(findings, job.warnings);
    addAll(findings, program->diagnostics());
    if (!job.check.isOff(rule_finding::kCommentShape.id))
        addAll(findings, differingComments(interpreted.proposals, job.setup.tools));
    publish(task, findings);
    if (read && kept.job.hasStock() && program->foreignKind() == nullptr)
        m_checks.submit(task.subject.uri, std::chrono::milliseconds(0),
                        [this, task, job, interpreted](const std::stop_token& stopCheck) {
                            guarded(task, [&] { run(task, job, interpreted, stopCheck); });
                        });
}

void LspAnalysis::run(const Task& task, Job job, const InterpretedJob& read, const std::stop_token& stop) {
    Result<std::shared_ptr<const CheckReport>> report;
    // One thread: the others are for the editor.
    onThisThread([&] {
        report = judgeJob(job, read, {.memoryBytes = memoryLimitBytes() / 2}, m_options.setup, {stop, {}});
    });
    if (stop.stop_requested())
        return;
    if (!report) {
        std::vector<CheckFinding> findings;
        addAll(findings, job.warnings);
        addAll(findings, read.program->diagnostics());
        addAll(findings, report.error());
        return publish(task, findings);
    }
    publish(task, (*report)->findings);
    m_output.notify("window/logMessage", {{"type", kLogMessage},
                                          {"message", fmt::format("{}: {}", job.program.filename().string(),
                                                                  name((*report)->verdict()))}});
}

void LspAnalysis::publish(const Task& task, std::span<const CheckFinding> findings) {
    m_publisher.publish(task.subject.uri, task.number, task.version, diagnosticsOf(findings, task.subject));
}

} // namespace proveout::cli
