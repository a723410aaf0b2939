// SPDX-License-Identifier: GPL-3.0-or-later
// check: judges programs, one or thousands.
#include <algorithm>
#include <atomic>
#include <cctype>
#include <cstdio>
#include <fmt/format.h>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "app/cli/check_inputs.h"
#include "app/cli/check_page.h"
#include "app/cli/check_program.h"
#include "app/cli/check_reports.h"
#include "app/cli/check_results.h"
#include "app/cli/command.h"
#include "app/cli/outputs.h"
#include "app/cli/part_json.h"
#include "app/cli/report.h"
#include "app/cli/thread_limit.h"
#include "core/base/atomic_file.h"
#include "core/verification/findings/check_findings.h"
#include "core/verification/findings/command_line_findings.h"
#include "core/verification/findings/exit_effect.h"

namespace proveout::cli {

namespace {

struct CheckCommand {
    CheckOptions check;
    ThreadLimit threads;
    std::vector<std::string> inputs;
    std::string sarif;
    std::string junit;
    std::string resume;
    std::string page;
    int jobs = 0;
    bool json = false;
};

ExitCode worseOf(ExitCode one, ExitCode other) {
    return static_cast<ExitCode>(worse(static_cast<ExitEffect>(one), static_cast<ExitEffect>(other)));
}

void print(const CheckFinding& finding) {
    fmt::print(stderr, "{}\n", oneLine(finding.diagnostic));
    if (!finding.waived)
        return;
    Diagnostic waived = diagnosticOf(check_finding::kWaived, {finding.waived->owner, finding.waived->reason});
    waived.file = finding.diagnostic.file;
    waived.where = finding.diagnostic.where;
    fmt::print(stderr, "{}\n", oneLine(waived));
}

class CheckRun {
public:
    explicit CheckRun(CheckCommand& command) : m_command(command), m_report("proveout-cli") {}

    ExitCode run() {
        const std::vector<std::filesystem::path> files = filesToCheck(m_command.inputs);
        std::vector<std::string> names = m_command.inputs;
        CheckRules anyRules;
        for (const std::filesystem::path& file : files)
            names.push_back(file.string());
        if (!fine(m_command.check.settings.apply(anyRules)) ||
            !fine(checkOutputs(names,
                               {{m_command.sarif}, {m_command.junit}, {m_command.resume}, {m_command.page}})))
            return m_report.exitCode();
        if (files.empty()) {
            m_report.addFatal({diagnosticOf(command_line_finding::kNothingToCheck)});
            return m_report.exitCode();
        }
        if (!m_command.page.empty() && files.size() > 1) {
            m_report.addFatal({diagnosticOf(command_line_finding::kReportOfMany)});
            return m_report.exitCode();
        }
        m_command.check.keepsResult = !m_command.page.empty();
        if (!m_command.resume.empty() &&
            !fine(m_results.open(m_command.resume, m_command.check.settings.text())))
            return m_report.exitCode();
        checkAll(files);
        if (!m_command.sarif.empty())
            (void)fine(write(m_command.sarif, m_sarif.text()));
        if (!m_command.junit.empty())
            (void)fine(write(m_command.junit, m_junit.text()));
        return worseOf(m_exitCode, m_report.exitCode());
    }

private:
    bool fine(Result<void> result) {
        if (!result)
            m_report.addFatal(std::move(result.error()));
        return result.has_value();
    }

    static Result<void> write(const std::string& file, const std::string& text) {
        AtomicFile out(file);
        out.write(text);
        return out.commit();
    }

    /// Several programs at once, each on one thread, because programs are independent; a single one may use
    /// them all.
    void checkAll(const std::vector<std::filesystem::path>& files) {
        const std::size_t wanted =
            m_command.jobs > 0 ? static_cast<std::size_t>(m_command.jobs) : ThreadLimit::threads();
        const std::size_t jobs = std::min(wanted, files.size());
        if (jobs > 1)
            m_command.threads.apply(1);
        std::atomic<std::size_t> next = 0;
        const auto work = [&] {
            for (std::size_t k = next++; k < files.size(); k = next++)
                checkOne(files[k]);
        };
        std::vector<std::jthread> others;
        for (std::size_t k = 1; k < jobs; ++k)
            others.emplace_back(work);
        work();
    }

    void checkOne(const std::filesystem::path& file) {
        if (const nlohmann::ordered_json* known = m_results.find(file)) {
            const std::scoped_lock lock(m_mutex);
            return note(*known);
        }
        const CheckedProgram result = checkProgram(file, m_command.check);
        nlohmann::ordered_json checked = toJson(result);
        checked["input"] = file.string();
        checked["settings"] = m_command.check.settings.text();
        const std::scoped_lock lock(m_mutex);
        if (!m_command.page.empty())
            (void)fine(writeReport(m_command.page, checked, result));
        m_results.add(checked);
        for (const CheckFinding& finding : result.report.findings)
            cli::print(finding);
        note(checked);
    }

    void note(const nlohmann::ordered_json& checked) {
        m_exitCode = worseOf(m_exitCode, static_cast<ExitCode>(checked.value("exitCode", 3)));
        m_sarif.add(checked);
        m_junit.add(checked);
        if (m_command.json)
            fmt::print("{}\n", jsonLine(checked));
        else
            print(checked);
        std::fflush(stdout);
    }

    static void print(const nlohmann::ordered_json& checked) {
        const bool unusable = checked.value("exitCode", 3) == static_cast<int>(ExitCode::unusable);
        std::string verdict = unusable ? "unusable" : checked.value("verdict", std::string());
        std::ranges::transform(verdict, verdict.begin(),
                               [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
        fmt::print("{:<10} {}\n", verdict, checked.value("program", std::string()));
        if (const auto contacts = checked.find("firstContacts"); contacts != checked.end())
            for (const nlohmann::ordered_json& contact : *contacts)
                fmt::print("  first contact of T{}: line {}, from X{:.3f} Y{:.3f} Z{:.3f}\n",
                           contact.value("tool", 0), contact.value("line", 0), contact.value("x", 0.0),
                           contact.value("y", 0.0), contact.value("z", 0.0));
        if (const auto part = checked.find("part"); part != checked.end())
            printPart(*part);
        for (const nlohmann::ordered_json& entry : checked["notChecked"])
            if (!entry.value("accepted", false))
                fmt::print("  not checked: {} [{}]\n", entry.value("title", std::string()),
                           entry.value("id", std::string()));
    }

    CheckCommand& m_command;
    Report m_report; ///< of the command itself
    CheckResults m_results;
    std::mutex m_mutex; ///< of all below
    SarifReport m_sarif;
    JunitReport m_junit;
    ExitCode m_exitCode = ExitCode::done;
};

} // namespace

void addCheckCommand(CLI::App& app, ExitCode& exitCode) {
    auto* command = app.add_subcommand("check", "Judge programs: safe, faults or unverified");
    auto options = std::make_shared<CheckCommand>();
    command->add_option("INPUT", options->inputs, "NC programs, job files, or folders with them")
        ->required()
        ->type_name("");
    options->check.setup.addSharedTo(*command);
    options->check.part.addTo(*command);
    options->check.settings.addTo(*command);
    options->threads.addTo(*command);
    command->add_flag("--json", options->json,
                      "Print one JSON object per program and line, as they are done");
    command
        ->add_option("--sarif", options->sarif,
                     "Write the findings for code reviews and editors (SARIF 2.1.0)")
        ->type_name("F.sarif");
    command->add_option("--junit", options->junit, "Write one test case per program (JUnit XML)")
        ->type_name("F.xml");
    command->add_option("--report", options->page, "Write the report of one program as a page (HTML)")
        ->type_name("F.html");
    command->add_option("--jobs", options->jobs, "Programs checked at once (one per thread)")
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
    command
        ->add_option(
            "--resume", options->resume,
            "Add each result to this file; skip programs whose results it holds and that are unchanged")
        ->type_name("F.jsonl");
    command->callback([options, command, &exitCode] {
        options->threads.apply();
        options->check.settings.note(*command);
        exitCode = CheckRun(*options).run();
    });
}

} // namespace proveout::cli
