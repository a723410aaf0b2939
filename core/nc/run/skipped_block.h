// SPDX-License-Identifier: GPL-3.0-or-later
// What a block that is skipped leaves in force all the same, so that one mistake does not change the motions
// after it.
#pragma once

#include <string_view>

#include "core/nc/text/block.h"

namespace proveout {

struct Execution;
struct CodeRow;

/// The words of a line that can be read, although the line cannot: those with plain numbers.
struct ReadableWords {
    Block block;
    bool codesKnown = true; ///< every G has a plain number
};

[[nodiscard]] ReadableWords readableWords(std::string_view line);

/// Puts in force the modes, the feed rate and the spindle speed of `execution.block`, whose motion is not
/// executed. Where the motion code cannot be known, because of `codesKnown`, two motion codes, or a canned
/// cycle without its levels, motions are skipped without a further message until one is programmed again.
void keepModes(Execution& execution, bool codesKnown);

/// Whether the motion code in force is not known because of a skipped block.
[[nodiscard]] bool isLost(const CodeRow* motion);

} // namespace proveout
