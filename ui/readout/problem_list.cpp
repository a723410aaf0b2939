// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/readout/problem_list.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "ui/session/session.h"

namespace proveout {

namespace {

/// Entries with equal sentences become one.
class Grouped {
public:
    void add(const Diagnostics& problems) {
        for (const Diagnostic& problem : problems) {
            const auto [known, isNew] =
                m_index.try_emplace({problem.id, problem.file, message(problem)}, m_all.size());
            if (isNew) {
                m_all.push_back({.diagnostic = problem, .lastLine = problem.where.line});
                continue;
            }
            CheckFinding& same = m_all[known->second];
            ++same.count;
            same.lastLine = std::max(same.lastLine, problem.where.line);
        }
    }
    [[nodiscard]] std::vector<CheckFinding> take() { return std::move(m_all); }

private:
    std::vector<CheckFinding> m_all;
    std::map<std::tuple<std::string, std::string, std::string>, std::size_t> m_index;
};

/// Of what the program text alone shows, the report has the same findings.
void markWaived(std::vector<CheckFinding>& problems, const CheckReport& report) {
    for (CheckFinding& problem : problems)
        if (const CheckFinding* judged = findingOf(report, problem.diagnostic))
            problem.waived = judged->waived;
}

} // namespace

const CheckFinding* findingOf(const CheckReport& report, const Diagnostic& diagnostic) {
    const auto found = std::ranges::find(report.findings, diagnostic, &CheckFinding::diagnostic);
    return found == report.findings.end() ? nullptr : &*found;
}

std::vector<CheckFinding> problemList(const Session& session) {
    const ProblemsHub& problems = session.problems();
    const auto& report = session.check().report();
    Grouped grouped;
    if (!report) {
        grouped.add(problems.all());
        return grouped.take();
    }
    for (const ProblemSource source :
         {ProblemSource::files, ProblemSource::stockFile, ProblemSource::simulation, ProblemSource::program})
        grouped.add(problems.of(source));
    std::vector<CheckFinding> all = grouped.take();
    markWaived(all, *report);
    all.insert(all.end(), report->findings.begin() + static_cast<std::ptrdiff_t>(report->ofText),
               report->findings.end());
    return all;
}

std::vector<CheckFinding> outdatedProblems(const Session& session, const std::vector<CheckFinding>& known) {
    const CheckHub& check = session.check();
    if (check.report() || !check.progress() || !check.before())
        return {};
    std::set<std::pair<std::string, std::string>> listed;
    for (const CheckFinding& one : known)
        listed.emplace(one.diagnostic.id, message(one.diagnostic));
    const CheckReport& before = *check.before();
    std::vector<CheckFinding> outdated(before.findings.begin() + static_cast<std::ptrdiff_t>(before.ofText),
                                       before.findings.end());
    std::erase_if(outdated, [&](const CheckFinding& one) {
        return listed.contains({one.diagnostic.id, message(one.diagnostic)});
    });
    return outdated;
}

std::vector<CheckFinding> problemsInText(const Session& session) {
    std::vector<CheckFinding> all;
    std::set<std::pair<std::string, int>> marked;
    const auto add = [&](const CheckFinding& problem) {
        const Diagnostic& diagnostic = problem.diagnostic;
        if (!ProblemsHub::isInText(diagnostic))
            return;
        marked.emplace(diagnostic.id, diagnostic.where.line);
        all.push_back(problem);
    };
    for (const Diagnostic& problem : session.problems().all())
        add({.diagnostic = problem, .lastLine = problem.where.line});
    if (const auto& report = session.check().report())
        for (const CheckFinding& found : report->findings)
            if (!marked.contains({found.diagnostic.id, found.diagnostic.where.line}))
                add(found);
    return all;
}

} // namespace proveout
