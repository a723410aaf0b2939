// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/zmap/stock_findings.h"

#include <fmt/format.h>
#include <string>
#include <utility>
#include <vector>

#include "core/base/figures_argument.h"
#include "core/zmap/stock_body_findings.h"

namespace proveout {

Diagnostics Undercut::reported() const {
    if (tallest <= kLeast)
        return {};
    std::vector<Argument> values{figures("{:.4g}", volumeMm3), figures("{:.3f}", tallest)};
    for (int axis = 0; axis < 3; ++axis)
        values.push_back(figures("{:.3f}", place[axis]));
    return {diagnosticOf(stock_body_finding::kStockUndercut, std::move(values))};
}

} // namespace proveout
