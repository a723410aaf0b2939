// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "ui/plots/plot_catalogue.h"

namespace proveout {

/// The data of a plot as CSV: a line of keys, then one line per row; separated by commas, with decimal points
/// in any locale.
[[nodiscard]] std::string plotCsv(const PlotSpec& plot, const PlotInput& input);

} // namespace proveout
