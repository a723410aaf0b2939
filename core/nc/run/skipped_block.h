// SPDX-License-Identifier: GPL-3.0-or-later
// Which values of a skipped block take effect nevertheless, so that one error does not change the motions
// after it.
#pragma once

#include <string_view>

#include "core/nc/text/block.h"

namespace proveout {

struct Execution;
struct CodeRow;

/// The readable words of a line that cannot be read as a whole: those with plain numbers.
struct ReadableWords {
    Block block;
    bool codesKnown = true; ///< every G has a plain number
};

[[nodiscard]] ReadableWords readableWords(std::string_view line);

/// Activates the modes, the feed rate and the spindle speed of `execution.block`, whose motion is not
/// executed. If the motion code is unknown, because of `codesKnown`, two motion codes, or a canned cycle
/// without its levels, motions are skipped without a further message until one is programmed again.
void keepModes(Execution& execution, bool codesKnown);

/// Whether the motion code in force is unknown because of a skipped block.
[[nodiscard]] bool isLost(const CodeRow* motion);

} // namespace proveout
