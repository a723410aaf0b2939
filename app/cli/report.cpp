// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/report.h"

#include <algorithm>
#include <cstdio>
#include <fmt/core.h>
#include <iterator>
#include <utility>

#include "core/verification/findings/exit_effect.h"
#include "core/verification/findings/findings.h"

namespace proveout::cli {

namespace {

nlohmann::ordered_json toJson(const Diagnostic& diagnostic) {
    nlohmann::ordered_json object{{"severity", name(diagnostic.severity)},
                                  {"id", diagnostic.id},
                                  {"title", findingTitle(diagnostic.id)},
                                  {"message", message(diagnostic)},
                                  {"file", diagnostic.file}};
    if (diagnostic.where.line > 0) {
        object["line"] = diagnostic.where.line;
        object["column"] = diagnostic.where.column;
    }
    if (*diagnostic.hint != '\0')
        object["hint"] = hintText(diagnostic);
    return object;
}

} // namespace

void Report::add(Diagnostics diagnostics) {
    for (Diagnostic& diagnostic : diagnostics) {
        if (diagnostic.file.empty())
            diagnostic.file = m_file;
        fmt::print(stderr, "{}\n", oneLine(diagnostic));
    }
    std::ranges::move(diagnostics, std::back_inserter(m_diagnostics));
}

void Report::addFatal(Diagnostics diagnostics) {
    m_fatal = true;
    add(std::move(diagnostics));
}

ExitCode Report::exitCode() const {
    ExitEffect effect = m_unverified ? ExitEffect::unverified : ExitEffect::none;
    if (m_fatal)
        effect = ExitEffect::unusable;
    for (const Diagnostic& diagnostic : m_diagnostics)
        effect = worse(effect, exitEffect(diagnostic.severity, diagnostic.unverified));
    return static_cast<ExitCode>(effect);
}

nlohmann::ordered_json Report::listed(bool unverified) const {
    auto list = nlohmann::ordered_json::array();
    for (const Diagnostic& diagnostic : m_diagnostics)
        if (diagnostic.unverified == unverified)
            list.push_back(toJson(diagnostic));
    return list;
}

nlohmann::ordered_json Report::findings() const {
    return listed(false);
}

nlohmann::ordered_json Report::unverified() const {
    return listed(true);
}

void printJson(const nlohmann::ordered_json& object) {
    const std::string text = object.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    fmt::print("{}\n", text);
}

} // namespace proveout::cli
