// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/decimation/parameters.h"

namespace proveout::cli {

/// Refuses outputs that would overwrite an input or one another. Empty names are skipped.
[[nodiscard]] Result<void> checkOutputs(const std::vector<std::string>& inputs,
                                        const std::vector<std::string>& outputs);

/// Refuses parameters whose surface has cracks.
[[nodiscard]] Result<void> checkExportable(const DecimationParameters& parameters);

} // namespace proveout::cli
