// SPDX-License-Identifier: GPL-3.0-or-later
// A message to the user about an input: one sentence, the place it is about, and a stable id.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "core/base/argument.h"

namespace proveout {

enum class Severity : std::uint8_t {
    note,    ///< worth knowing, nothing to do
    warning, ///< probably not what was meant
    error,   ///< could not be read or interpreted
    fault,   ///< the program would cause damage (exit code 1 of the command line)
};

/// A place in a text file. Lines and columns are 1-based, columns count bytes; 0 means "the whole file".
struct TextRange {
    int line = 0;
    int column = 0;
    int length = 0;

    friend bool operator==(const TextRange&, const TextRange&) = default;
};

/// One message. `text` is a literal marked with PROVEOUT_TEXT in which each `{}` is replaced by the next
/// argument, so that the workstation can translate the sentence and keep the arguments.
struct Diagnostic {
    Severity severity = Severity::error;
    bool unverified = false; ///< everything after this place is unverified (exit code 2)
    const char* id = "";     ///< stable, kebab-case, e.g. "arc-ends-differ"
    const char* text = "";
    std::vector<Argument> arguments;
    const char* hint = ""; ///< what to do about it; a literal marked with PROVEOUT_TEXT, may be empty
    std::string file;
    TextRange where;

    /// Texts are literals and compared by address; in the worst case one message counts as two.
    friend bool operator==(const Diagnostic&, const Diagnostic&) = default;
};

using Diagnostics = std::vector<Diagnostic>;

/// A value, or the reasons why there is none (never empty).
template<class T>
using Result = tl::expected<T, Diagnostics>;

/// Replaces each `{}` of `text` by the next of `arguments`; surplus arguments are ignored, missing ones leave
/// `{}`. A translation that needs another order writes `{1}`, `{2}`, … instead.
[[nodiscard]] std::string fillIn(std::string_view text, const std::vector<std::string>& arguments);

/// The English sentence of a diagnostic.
[[nodiscard]] std::string message(const Diagnostic& diagnostic);

/// What to do about it, in English; may be empty. It may name the arguments of the sentence, by `{1}`, `{2}`,
/// …
[[nodiscard]] std::string hintText(const Diagnostic& diagnostic);

/// `FILE:LINE:COLUMN: error: sentence [id]`; control characters that a terminal obeys and bytes that are not
/// UTF-8 are escaped.
[[nodiscard]] std::string oneLine(const Diagnostic& diagnostic);

/// "note", "warning", "error" or "fault".
[[nodiscard]] const char* name(Severity severity);

} // namespace proveout
