// SPDX-License-Identifier: GPL-3.0-or-later
// A row of the tables of findings: everything of a diagnostic that is known before a program is read. Each
// library of the core has its rows in a header of its own; core/verification/findings collects them.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "core/base/diagnostic.h"

namespace proveout {

/// What else, besides the row, decides how severe a finding is.
enum class SeverityRule : std::uint8_t {
    fixed,            ///< nothing: always as the row says
    warningIfAssumed, ///< a warning where it is based on assumed sizes, such as those of a tool that is not
                      ///< confirmed
    worstOmitted,     ///< as the worst of the findings that were only counted
};

/// A finding without its place and arguments. All texts are literals, marked with PROVEOUT_TEXT where the
/// window shows them.
struct FindingRow {
    Severity severity = Severity::error;
    bool unverified = false; ///< everything after its place is unverified
    const char* id = "";     ///< stable, kebab-case; rows with one id share their title
    const char* title = "";  ///< a short name without arguments, e.g. "Rapid cuts stock"
    const char* text = "";   ///< a sentence; each `{}` is replaced by the next argument
    const char* hint = "";   ///< what to do about it; may be empty, and name arguments by `{1}`, `{2}`, …
    SeverityRule severityRule = SeverityRule::fixed;
};

/// The part of the software that reports a finding.
enum class FindingSource : std::uint8_t {
    files,       ///< files read and written, of any kind
    reader,      ///< the text of the program: lines, words, expressions
    interpreter, ///< what the blocks of the program do
    lint,        ///< what is allowed but seldom intended
    tools,       ///< cutters and the tool table
    stock,       ///< the stock and its grid
    setup,       ///< the setup and the machine
    simulation,  ///< cutting
    rules,       ///< what is judged once a program has been run
    decimation,  ///< the mesh of the stock
    study,       ///< parameter studies
    jobFile,     ///< jobs
    exporting,   ///< meshes and other files that are written
    breakpoints, ///< conditions that stop a run
    window,      ///< what only the window does: backups, work in the background, its export
    commandLine, ///< options and outputs of a command
};

/// kebab-case, e.g. "job-file": for machine-readable listings.
[[nodiscard]] const char* name(FindingSource source);

/// Rows that one part of the software reports.
struct FindingTable {
    FindingSource noticedBy;
    std::span<const FindingRow* const> rows;
    bool refusesInput; ///< an error among them makes the input unusable and ends a command
};

/// The finding of a row, at no place in particular.
[[nodiscard]] Diagnostic diagnosticOf(const FindingRow& row, std::vector<Argument> arguments = {});

/// Whether a diagnostic is a finding of the row, or of another with the same id.
[[nodiscard]] bool hasIdOf(const Diagnostic& diagnostic, const FindingRow& row);

/// A result that failed with the finding of a row.
[[nodiscard]] tl::unexpected<Diagnostics> failure(const FindingRow& row, std::vector<Argument> arguments = {},
                                                  std::string file = {});

} // namespace proveout
