// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace proveout::samples {

/// The job file of a sample: its stock, the paper's cutter, grid, region size, period and error allowance.
[[nodiscard]] std::string jobText(std::string_view program, int width, int depth, int height);

} // namespace proveout::samples
