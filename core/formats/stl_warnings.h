// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/formats/stl.h"

namespace proveout {

/// Adds to the warnings of `contents` what its counts, its defects and its size show.
void warnOfStl(StlContents& contents);

} // namespace proveout
