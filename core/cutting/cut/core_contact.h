// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the middle of a tool, which does not cut, meets material on the way straight down.
#pragma once

#include <optional>

#include "core/cutter/cutter.h"
#include "core/cutting/cut/assembly_contact.h"
#include "core/nc/program/motion.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// The core of a tool that is not centre-cutting, as parts of its diameter: how wide it is, and how far it is
/// ground hollow. A hole that is drilled for it is wider than that, and stock left on a floor is lower.
inline constexpr double kCoreWidth = 0.5;
inline constexpr double kCoreHollow = 0.05;

/// Whether a motion has a core contact at all: a tool that is not centre-cutting goes straight down at feed.
[[nodiscard]] bool plungesWithCore(const Cutter& cutter, const Motion& motion);

/// The contact of the core on such a motion: by how much the stock in its way is higher than the end of the
/// motion, and where, over the points of the grid. `before`: the map before the motion is cut. Any thread;
/// takes time in proportion to the points below the core.
[[nodiscard]] PartContact coreContact(const ZMap& before, const Cutter& cutter, const Motion& motion);

} // namespace proveout
