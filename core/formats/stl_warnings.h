// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/formats/stl.h"

namespace proveout {

/// Adds warnings to `contents` according to its counts, its defects and its size.
void warnOfStl(StlContents& contents);

} // namespace proveout
