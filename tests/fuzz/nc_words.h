// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace proveout::test {

/// Words of NC programs: every code of every dialect, every letter, and the keywords.
[[nodiscard]] std::vector<std::string> ncWords();

} // namespace proveout::test
