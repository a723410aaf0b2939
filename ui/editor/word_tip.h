// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/nc/word_help.h"

namespace proveout {

/// The meaning of a word in a dialect as a short text of one to three lines.
[[nodiscard]] QString readableHelp(const WordHelp& help, DialectId dialect);

} // namespace proveout
