// SPDX-License-Identifier: GPL-3.0-or-later
// How codes put offsets into force, for those that do so besides something else.
#pragma once

#include "core/base/geometry.h"

namespace proveout {

struct Execution;

/// Puts a tool length offset in force: the machine stands still, its tip is elsewhere afterwards.
void setToolOffset(Execution& execution, const Vec3& offset);

/// Puts a work offset into force by its number: 1 for G54.
void selectSystem(Execution& execution, int system);

} // namespace proveout
