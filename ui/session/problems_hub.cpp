// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/problems_hub.h"

#include <utility>

namespace proveout {

bool ProblemsHub::isInText(const Diagnostic& problem) {
    return problem.where.line > 0 && problem.file.empty();
}

void ProblemsHub::report(const Diagnostics& messages) {
    set(ProblemSource::files, messages);
    refresh();
    if (!messages.empty())
        emit troubled();
}

void ProblemsHub::add(const Diagnostics& messages) {
    Diagnostics& files = m_bySource.at(static_cast<std::size_t>(ProblemSource::files));
    files.insert(files.end(), messages.begin(), messages.end());
    refresh();
    if (!messages.empty())
        emit troubled();
}

void ProblemsHub::set(ProblemSource source, Diagnostics problems) {
    m_bySource.at(static_cast<std::size_t>(source)) = std::move(problems);
}

void ProblemsHub::refresh() {
    m_all.clear();
    for (const Diagnostics& each : m_bySource)
        m_all.insert(m_all.end(), each.begin(), each.end());
    emit changed();
}

} // namespace proveout
