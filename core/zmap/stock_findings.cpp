// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/zmap/stock_findings.h"

#include <fmt/format.h>

#include "core/base/text.h"

namespace proveout {

Diagnostics Undercut::told() const {
    if (tallest <= kLeast)
        return {};
    Diagnostic finding;
    finding.unverified = true;
    finding.id = "stock-undercut";
    finding.text =
        PROVEOUT_TEXT("Core", "Under the surface of the stock there are {} mm³ of air, which the z-map "
                              "shows as material; the tallest gap, {} mm, begins at X{} Y{} Z{}.");
    finding.arguments = {fmt::format("{:.4g}", volumeMm3), fmt::format("{:.3f}", tallest)};
    for (int axis = 0; axis < 3; ++axis)
        finding.arguments.push_back(fmt::format("{:.3f}", place[axis]));
    finding.hint = PROVEOUT_TEXT("Core", "Check by other means what the program does over such gaps.");
    return {finding};
}

} // namespace proveout
