// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/nc/codes/word_help.h"
#include "core/nc/program/line_values.h"

namespace proveout {

/// The meaning of a word in a dialect as a short text of one to three lines.
[[nodiscard]] QString readableHelp(const WordHelp& help, DialectId dialect);

/// What the word says where its line is executed first: the value with its unit, the parameter before and
/// behind the line, the codes of its group that are in force. Empty where there is nothing to say.
[[nodiscard]] QString readableValues(const WordHelp& help, const LineValues& values);

} // namespace proveout
