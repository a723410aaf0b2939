// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/nc/text/block.h"

namespace proveout {

struct Execution;
struct FindingRow;

/// Tells what is due to the radius of the tool: a warning only where that is assumed.
void reportOfRadius(Execution& execution, const FindingRow& message, const Word& word,
                    std::vector<Argument> arguments);

} // namespace proveout
