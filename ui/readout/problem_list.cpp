// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/readout/problem_list.h"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>

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

} // namespace

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
    all.insert(all.end(), report->findings.begin() + static_cast<std::ptrdiff_t>(report->ofText),
               report->findings.end());
    return all;
}

} // namespace proveout
