// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/nc/program/program.h"
#include "core/simulation/setup/setup.h"

namespace proveout {

/// Interprets a text; the start position is unknown, as on a machine.
[[nodiscard]] std::shared_ptr<const Program> programOf(const std::string& text);

/// A program of `blocks` motion blocks over a 40 × 30 mm stock: slanted, level and plunging feeds, arcs, and
/// retracts by G0, cutting down to -8 mm. Equal seeds give equal programs.
[[nodiscard]] std::string randomProgram(std::uint_fast32_t seed, int blocks);

/// Four blocks, of which the third takes seconds on the stock of `wideSetup`: a cone of 100 mm that pecks by
/// two micrometres.
[[nodiscard]] std::shared_ptr<const Program> programOfOneLongBlock();
/// A 500 × 500 × 60 mm stock with its corner at the origin, and T1, a cone of 100 mm.
[[nodiscard]] std::shared_ptr<const Setup> wideSetup();

/// A 40 × 30 × 10 mm stock with its corner at the origin, and T1, a 4 mm ball-end mill.
[[nodiscard]] std::shared_ptr<const Setup> smallSetup(double spacing = 0.5);

/// The same with another cutter, added or replacing T1.
[[nodiscard]] std::shared_ptr<const Setup> setupWithTool(int number, const std::string& spec);

} // namespace proveout
