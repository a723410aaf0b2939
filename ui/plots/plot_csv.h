// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "ui/plots/plot_catalogue.h"

namespace proveout {

/// The data of a plot: a line of keys, then a line a row; comma and point whatever the locale.
[[nodiscard]] std::string plotCsv(const PlotSpec& plot, const PlotInput& input);

} // namespace proveout
