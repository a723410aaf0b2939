// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/finding_row.h"

#include <string_view>
#include <utility>

namespace proveout {

const char* name(FindingSource source) {
    switch (source) {
    case FindingSource::files:
        return "files";
    case FindingSource::reader:
        return "reader";
    case FindingSource::interpreter:
        return "interpreter";
    case FindingSource::lint:
        return "lint";
    case FindingSource::tools:
        return "tools";
    case FindingSource::stock:
        return "stock";
    case FindingSource::setup:
        return "setup";
    case FindingSource::simulation:
        return "simulation";
    case FindingSource::rules:
        return "rules";
    case FindingSource::decimation:
        return "decimation";
    case FindingSource::study:
        return "study";
    case FindingSource::jobFile:
        return "job-file";
    case FindingSource::exporting:
        return "export";
    case FindingSource::breakpoints:
        return "breakpoints";
    case FindingSource::window:
        return "window";
    case FindingSource::commandLine:
        return "command-line";
    }
    return "files";
}

Diagnostic diagnosticOf(const FindingRow& row, std::vector<Argument> arguments) {
    return {row.severity, row.unverified, row.id, row.text, std::move(arguments), row.hint, {}, {}};
}

bool hasIdOf(const Diagnostic& diagnostic, const FindingRow& row) {
    return std::string_view(diagnostic.id) == row.id;
}

tl::unexpected<Diagnostics> failure(const FindingRow& row, std::vector<Argument> arguments,
                                    std::string file) {
    Diagnostic diagnostic = diagnosticOf(row, std::move(arguments));
    diagnostic.file = std::move(file);
    return tl::unexpected<Diagnostics>(Diagnostics{std::move(diagnostic)});
}

} // namespace proveout
