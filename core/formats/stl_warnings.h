// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/formats/stl.h"

namespace proveout {

/// A warning about an STL file; id and text are literals.

/// Adds to the warnings of `contents` what its counts, its defects and its size show.
void warnOfStl(StlContents& contents);

} // namespace proveout
