// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/nc/codes/word_help.h"
#include "core/nc/program/line_values.h"

namespace proveout {

/// The meaning of a word in a dialect as a short text of one to three lines.
[[nodiscard]] QString readableHelp(const WordHelp& help, DialectId dialect);

/// The values of a word when its line is first executed: the value with its unit, the parameter before and
/// after the line, the active codes of its group. Empty if there is nothing to show.
[[nodiscard]] QString readableValues(const WordHelp& help, const LineValues& values);

} // namespace proveout
