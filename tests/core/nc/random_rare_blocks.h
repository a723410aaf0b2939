// SPDX-License-Identifier: GPL-3.0-or-later
// Codes of LinuxCNC's language that programs seldom have, by chance.
#pragma once

#include <string>
#include <vector>

#include "tests/core/nc/random_words.h"

namespace proveout::test {

/// Lines with NURBS, probing, lathe cycles, threads, diameter mode, the planes of other axes, or inputs.
[[nodiscard]] std::vector<std::string> randomRareBlocks(RandomWords& words);

} // namespace proveout::test
