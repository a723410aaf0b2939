// SPDX-License-Identifier: GPL-3.0-or-later
// The core speaks English with marked strings; here they become the user's language.
#pragma once

#include <string>
#include <vector>

#include <QString>

#include "core/base/diagnostic.h"

namespace proveout {

/// A string that the core marked with PROVEOUT_TEXT, translated.
[[nodiscard]] QString coreText(const char* text);
/// The same for a sentence, its arguments filled in.
[[nodiscard]] QString coreText(const char* text, const std::vector<Argument>& arguments);
/// Figures that the core has written with a decimal point, e.g. "1.5 GB", with that of the language.
[[nodiscard]] QString figuresText(const std::string& figures);
/// The sentence of a diagnostic, translated, its arguments filled in.
[[nodiscard]] QString sentence(const Diagnostic& diagnostic);
/// What to do about it, translated; may be empty.
[[nodiscard]] QString hint(const Diagnostic& diagnostic);
/// "Error", "Warning", …
[[nodiscard]] QString severityName(Severity severity);

} // namespace proveout
