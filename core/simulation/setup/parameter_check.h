// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/diagnostic.h"
#include "core/decimation/regions/parameters.h"

namespace proveout {

/// Refuses parameters out of the ranges that describe() names; the message tells the first.
[[nodiscard]] Result<void> checkRanges(const DecimationParameters& parameters);

} // namespace proveout
