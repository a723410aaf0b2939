// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/diagnostic.h"
#include "core/decimation/regions/parameters.h"

namespace proveout {

/// Refuses parameters outside the ranges that describe() gives; the message names the first.
[[nodiscard]] Result<void> checkRanges(const DecimationParameters& parameters);

} // namespace proveout
