// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>

#include "core/nc/run/interpreter.h"

namespace proveout::cli {

/// Writes the lines whose motions differ between two dialects, as JSON Lines: {"k":"differs"} with line,
/// source and the motions in each dialect, then {"k":"sum"} with their number.
void writeDifferences(std::ostream& out, const NcText& text, InterpretOptions options, DialectId one,
                      DialectId other);

} // namespace proveout::cli
