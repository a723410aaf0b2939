// SPDX-License-Identifier: GPL-3.0-or-later
// Random blocks with rarely used codes of LinuxCNC's language.
#pragma once

#include <string>
#include <vector>

#include "tests/core/nc/random_words.h"

namespace proveout::test {

/// Lines with NURBS, probing, lathe cycles, threads, diameter mode, planes of other axes, or inputs.
[[nodiscard]] std::vector<std::string> randomRareBlocks(RandomWords& words);

} // namespace proveout::test
