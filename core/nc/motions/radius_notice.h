// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/base/argument.h"
#include "core/nc/text/block.h"

namespace proveout {

struct Execution;
struct FindingRow;

/// Reports a problem caused by the tool radius; only a warning if the radius is assumed.
void reportOfRadius(Execution& execution, const FindingRow& message, const Word& word,
                    std::vector<Argument> arguments);

} // namespace proveout
