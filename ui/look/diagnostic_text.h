// SPDX-License-Identifier: GPL-3.0-or-later
// Translates the marked English strings of the core into the user's language.
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
/// Figures that the core has formatted with a decimal point, e.g. "1.5 GB", converted to the decimal
/// separator of the language.
[[nodiscard]] QString figuresText(const std::string& figures);
/// The translated sentence of a diagnostic with its arguments.
[[nodiscard]] QString sentence(const Diagnostic& diagnostic);
/// The translated hint of a diagnostic; may be empty.
[[nodiscard]] QString hint(const Diagnostic& diagnostic);
/// "Error", "Warning", …
[[nodiscard]] QString severityName(Severity severity);

} // namespace proveout
