// SPDX-License-Identifier: GPL-3.0-or-later
// Sets offsets on behalf of codes that have further effects.
#pragma once

#include "core/base/geometry.h"

namespace proveout {

struct Execution;

/// Activates a tool length offset: the machine does not move; the position of its tip changes.
void setToolOffset(Execution& execution, const Vec3& offset);

/// Activates a work offset by its number: 1 for G54.
void selectSystem(Execution& execution, int system);

} // namespace proveout
